#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/model/surface_curve.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/geometry/rays/ray.h"
#include "keiko/intersect/traversal/tracer.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace keiko {

/// A piece of a placed face's border, or of a crease inside a face, as a curve in space: world, mm.
/// Of degree 5, it meets the exact curve's position and first two derivatives at its ends.
struct BoundaryPiece {
    static constexpr std::size_t points = 6; ///< control points of a curve
    using Curve = std::array<Vec3, points>;  ///< control points

    std::uint32_t instance = 0, face = 0; ///< into the model's arrays
    Vec3 center{0};                       ///< world, mm
    double radius = 0;                    ///< mm, of the ball about the centre that holds the curve
    /// Control points relative to the centre, mm.
    Curve curve{Vec3(0), Vec3(0), Vec3(0), Vec3(0), Vec3(0), Vec3(0)};
    /// mm: how far beside the curve rays may still meet the surface: the largest distance to the
    /// exact curve that was met between its ends, and the seam's reach beyond that.
    double error = 0;
    Box3 box; ///< world, mm, around all that is within `error` of the curve
    /// Unit, from the border into the surface and tangent to it, at begin, middle and end.
    std::array<Vec3, 3> inward{Vec3(0), Vec3(0), Vec3(0)};
    /// rad: how far inward_at() may be off; pi / 2 near poles and cusps.
    double inward_error = 0;
    /// Cone about `normal` that holds the normals on both sides where the surface goes on beyond
    /// the border without a gap, half angle in rad. Viewed from outside of all their tangent planes
    /// the surface covers both sides of the border, which then hides nothing first or last. An
    /// angle above pi / 2 says nothing.
    Vec3 normal{0, 0, 1};
    double normal_angle = 4; ///< rad, half angle of the cone
    /// True for a crease in a trimmed face, which is material only in parts.
    bool trimmed = false;
    Vec2 first{0}, last{0}; ///< face parameters

    /// False when the viewpoint is proved to see both sides' tangent planes from one side all
    /// along.
    bool may_be_edge_on(const Viewpoint& viewpoint) const {
        return may_be_edge_on(viewpoint, curve);
    }
    /// True if a part of the curve may be edge-on.
    bool may_be_edge_on(const Viewpoint& viewpoint, const Curve& part) const;
    /// Position relative to the centre, mm; t from 0 to 1.
    Vec3 at(double t) const;
    /// Derivative of the position by t, mm.
    Vec3 derivative(double t) const;
    /// The direction into the surface, interpolated.
    Vec3 inward_at(double t) const;
};

/// Point of a curve of degree 5 at t.
Vec3 point_on(const BoundaryPiece::Curve& curve, double t);

/// The borders of every placed face, trimmed or natural, and the knot lines along which the normal
/// jumps. Left out: the sides of a closed face that join smoothly, and sides collapsed into a
/// point. `tracer` is of the same model, and not kept. Throws Cancelled.
std::vector<BoundaryPiece> boundary_pieces(const SurfaceModel& model, const Tracer& tracer,
                                           const Job& job);

/// mm: how far beside the borders of a placed face, or the creases inside it, a ray may still meet
/// the face for the tracer's room for rounding.
double boundary_reach(const SurfaceModel& model, std::uint32_t instance, std::uint32_t face);

/// Reach beside one trim curve, whose seam may be wider.
double boundary_reach(const SurfaceModel& model, const Tracer& tracer, std::uint32_t instance,
                      std::uint32_t face, std::uint32_t trim_curve);

/// A side of a placed patch inside its face, along which the face's normal jumps.
struct CreaseLine {
    std::uint32_t instance = 0, face = 0; ///< into the model's arrays
    std::array<Vec3, 2> p_curve;          ///< homogeneous, face parameters, the patch on its left
};

/// The creases inside the faces of a model, each once from either side. A jump is one of more than
/// 1e-9 rad at any of nine places of a side. Looks into the model it was made from.
class CreaseLines {
public:
    /// Finds all creases of a model.
    explicit CreaseLines(const SurfaceModel& model);

    /// Creases by instance, then by face.
    const std::vector<CreaseLine>& all() const { return lines_; }
    /// Crease as a curve in space, world, mm.
    SurfaceCurve curve(const CreaseLine& line) const;
    /// Unit, tangent to the surface on the other side of the line, from its place at t into that.
    std::optional<Vec3> inward_beyond(const CreaseLine& line, double t) const;

private:
    bool normal_jumps(std::uint32_t patch, const CreaseLine& line) const;

    const SurfaceModel* model_;
    std::vector<PatchGrid> grids_; ///< a face
    std::vector<CreaseLine> lines_;
};

/// The direction into the surface that goes on beyond a curve, at its parameter and place; nothing
/// where none does.
using Beyond = std::function<std::optional<Vec3>(double, const Vec3&)>;

/// Pieces that cover a curve, each as `kind` except for what follows from the curve. Each patch's
/// share is halved, ten times at most, until the pieces are within 1e-9 of the curve's size, or
/// rounding, and their legs turn by less than 0.4 rad from their chords. The distance of a piece to
/// its curve is added to the kind's error. None for a curve that is a point.
std::vector<BoundaryPiece> curve_cover(const SurfaceCurve& curve, const Beyond& beyond,
                                       const BoundaryPiece& kind);

/// Matrix of the values or control points of a curve of degree 5, rows outer.
using CurveMatrix = std::array<std::array<double, BoundaryPiece::points>, BoundaryPiece::points>;

/// Parameter of the k-th place that a curve through places is given by: Chebyshev's in [0, 1], both
/// ends among them.
double curve_node(std::size_t k);

/// Matrix that turns values at the nodes into the control points of the polynomial through them.
const CurveMatrix& control_points_of_values();

/// Control points of the curve of degree 5 that has these values at the nodes.
template <class T>
std::array<T, BoundaryPiece::points> curve_through(
    const std::array<T, BoundaryPiece::points>& values) {
    const CurveMatrix& matrix = control_points_of_values();
    std::array<T, BoundaryPiece::points> curve = values;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        curve[i] = values[0] * matrix[i][0];
        for (std::size_t k = 1; k < values.size(); ++k) curve[i] += values[k] * matrix[i][k];
    }
    return curve;
}

} // namespace keiko
