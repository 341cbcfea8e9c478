#pragma once

#include "keiko/geometry/trim/trim_region.h"
#include "keiko/inspect/basics/placed_patch.h"

#include <optional>
#include <vector>

namespace keiko {

/// A face where an instance places it, over all its knot spans. Places of it are (u, v), their
/// whole parts count spans, the rest runs over one from 0 to 1. Looks into the model.
class FaceSurface {
public:
    FaceSurface(const SurfaceModel& model, std::uint32_t instance, std::uint32_t face);

    /// The surface at a place, with its derivatives by (u, v) up to `order`, world, mm; nothing
    /// where there is no material.
    std::optional<SurfaceDerivatives> evaluate(const Vec2& place, int order) const;
    /// The same whatever the trims, and up to a quarter of a span beyond the sides of the face.
    std::optional<SurfaceDerivatives> evaluate_beyond(const Vec2& place, int order) const;
    bool has_material(const Vec2& place) const;
    /// Where the parameters of the face are.
    Vec2 place_of(const Vec2& face_parameters) const;
    /// -1 where the outward normal is -(du x dv).
    double sign() const { return sign_; }

    std::size_t spans_u() const { return begins_u_.size(); }
    std::size_t spans_v() const { return begins_v_.size(); }
    /// mm, of the longest row of control points of any patch in each span along u, along v.
    std::vector<double> span_lengths_u() const;
    std::vector<double> span_lengths_v() const;

private:
    std::uint32_t patch_in(std::size_t column, std::size_t row) const {
        return table_[row * begins_u_.size() + column];
    }
    /// Into patches_, of the span that holds the place or is next to it; no_index where none is.
    std::uint32_t patch_at(const Vec2& place, Vec2& uv) const;

    const SurfaceModel& model_;
    TrimRegion trims_;
    double sign_;
    std::vector<PlacedPatch> patches_;
    std::vector<double> begins_u_, begins_v_; ///< of the spans, in face parameters
    std::vector<std::uint32_t> table_;        ///< into patches_, v outer
};

} // namespace keiko
