#pragma once

#include "keiko/geometry/bezier/bezier.h"
#include "keiko/geometry/trim/trim_region.h"
#include "keiko/inspect/basics/placed_face.h"

#include <optional>
#include <vector>

namespace keiko {

/// A place of one of several faces.
struct SheetPoint {
    std::size_t face = 0; ///< into FaceAdjacency
    Vec2 place{0};        ///< of that FaceSurface
};

/// A side of a knot span that is one point. Places along it are begin + t * along, 0 <= t <= 1.
struct CollapsedSide {
    Vec2 begin{0};
    Vec2 along{0};
    Vec2 inward{0}; ///< over the span to its other side
};

/// A face placed by an instance, over all its knot spans. Its places are (u, v): their whole parts
/// count spans, the rest runs over one span from 0 to 1. Keeps a reference to the model.
class FaceSurface {
public:
    /// `instance` and `face`: into the arrays of SurfaceModel.
    FaceSurface(const SurfaceModel& model, std::uint32_t instance, std::uint32_t face);

    /// The surface at a place, with its derivatives by (u, v) up to `order`, world, mm; nullopt if
    /// there is no material.
    std::optional<SurfaceDerivatives> evaluate(const Vec2& place, int order) const;
    /// The surface regardless of trims, up to a quarter of a span beyond the sides of the face.
    std::optional<SurfaceDerivatives> evaluate_beyond(const Vec2& place, int order) const;
    /// True if a place lies within the sides of the face and its trims.
    bool has_material(const Vec2& place) const;
    /// Place of parameters of the face.
    Vec2 place_of(const Vec2& face_parameters) const;
    /// Outward unit normal by the derivatives at a place; nullopt at a pole and so close to it that
    /// curvatures are rounding (has_reliable_curvatures).
    std::optional<Vec3> normal(const SurfaceDerivatives& there) const;

    /// True if its patches are the cells of a grid, each of them one: a flaw search passes over
    /// what is no such patch.
    bool is_grid() const;
    /// mm, world: about the diagonal of a box around it, by the corners of its patches.
    double size() const;
    /// Number of knot spans along u.
    std::size_t spans_u() const { return begins_u_.size(); }
    /// Number of knot spans along v.
    std::size_t spans_v() const { return begins_v_.size(); }
    /// Sides of the face, a span at a time, whose control points are within `coincident` mm.
    std::vector<CollapsedSide> collapsed_sides(double coincident) const;
    /// Length of the longest row of control points along u of any patch, mm, in each span of u.
    std::vector<double> span_lengths_u() const;
    /// Length of the longest row of control points along v of any patch, mm, in each span of v.
    std::vector<double> span_lengths_v() const;

private:
    std::uint32_t patch_in(std::size_t column, std::size_t row) const {
        return table_[row * begins_u_.size() + column];
    }
    /// Index into patches_ of the span that holds the place or is next to it; no_index if there is
    /// none.
    std::uint32_t patch_at(const Vec2& place, Vec2& uv) const;

    const SurfaceModel& model_;
    TrimRegion trims_;
    double sign_;
    std::vector<PlacedPatch> patches_;
    std::vector<double> begins_u_, begins_v_; ///< of the spans, in face parameters
    std::vector<std::uint32_t> table_;        ///< into patches_, v outer
};

} // namespace keiko
