#pragma once

#include "keiko/base/export.h"
#include "keiko/drawing/curves/image_projection.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/math/vec.h"

#include <array>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

namespace KEIKO_API keiko {

/// Kind of a curve of a drawing, and its layer there.
enum class CurveKind {
    outline, ///< contour generator of a smooth face, or a crease that is a contour edge
    edge,    ///< free edge: a border that meets no other
    crease,  ///< border or knot line at which the normal jumps
    seam,    ///< border at which two faces join smoothly
    iso,     ///< of constant u or v
    section, ///< of a plane with the body
    line     ///< reflection line, highlight line or isophote of a lamp
};
/// Number of kinds.
constexpr std::size_t curve_kinds = 7;
/// Name of the layer: "outlines", "edges", "creases", "seams", "iso-curves", "sections", "lines".
std::string_view name_of(CurveKind kind);

/// A curve in space by points of it and its exact course between them. Its parameter is 0, 1, 2...
/// at the points.
struct CurveCourse {
    std::vector<Vec3> points{}; ///< world, mm, on the exact curve; two at least
    /// The point of the exact curve at a share of the way from one of `points` to the next; empty:
    /// the curve is its chords.
    std::function<Vec3(std::size_t, double)> between{};

    /// The greatest parameter.
    double end() const { return static_cast<double>(points.size() - 1); }
    /// The point at a parameter from 0 to end().
    Vec3 at(double t) const;
    /// Derivative by the parameter, mm, to about 1e-6 of it; one-sided towards the inside of a
    /// chord.
    Vec3 derivative(double t) const;
    /// Length of the chords, mm.
    double length() const;
};

/// A place where a curve pierces the surface of a face on which it does not lie.
struct Piercing {
    double t = 0;   ///< parameter of the curve
    Vec3 normal{0}; ///< unit, of the face, of either sense
};

/// A curve on a body, as a drawing needs it.
struct ModelCurve {
    CurveKind kind = CurveKind::edge; ///< its layer
    CurveCourse course{};             ///< in space
    std::vector<PlacedFace> faces{};  ///< that it lies on
    double reach = 0; ///< mm: how far the curve may lie from the surface of these faces
    /// Parameters at which an outline has a cusp in the image, as it runs along the line of sight
    /// there; rising.
    std::vector<double> cusps{};
    std::vector<Piercing> piercings{}; ///< by rising parameter
    /// Directions into both faces of a crease at a share of the way from one of the points to the
    /// next, unit, square to the curve; 0 where unknown.
    std::function<std::array<Vec3, 2>(std::size_t, double)> sides{};

    /// True if both faces of a crease are on one side of it in the image. Of a closed body one of
    /// them is turned to the eye and one away: the edge is a part of the body's outline there.
    bool is_contour_edge(double t, const ImageProjection& projection) const;
};

/// A curve behind which the number of sheets of the surface changes: a border of a face, at which
/// one sheet ends, or a contour generator, at which two do.
struct OccludingCurve {
    PlacedFace face;    ///< that it lies on
    int sheets = 1;     ///< that end here: 1 or 2
    CurveCourse course; ///< in space
    /// A direction at a share of the way from one of the points to the next, of any length: its
    /// image points to the side on which the sheets are. 0 where unknown.
    std::function<Vec3(std::size_t, double)> inward;

    /// inward at a parameter of the course.
    Vec3 inward_at(double t) const;
};

} // namespace keiko
