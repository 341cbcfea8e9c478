#pragma once

#include "keiko/geometry/bezier/bezier.h"
#include "keiko/geometry/bezier/parameter_metric.h"
#include "keiko/geometry/trim/trim_region.h"
#include "keiko/inspect/openings/free_edges.h"
#include "keiko/intersect/hit/hit.h"

#include <optional>

namespace keiko {

/// The material of a face that lies farther from all of its borders than a margin. Keeps references
/// to the model and the face.
class FaceInside {
public:
    /// Material of `face` farther than `margin` mm from its borders. The natural sides of a face
    /// without loops are borders too.
    FaceInside(const SurfaceModel& model, const Face& face, double margin);

    /// Position of a box of a patch's parameters relative to the trims; inside for a face without
    /// loops.
    TrimSide side(std::uint32_t patch, const Box2& uv);
    /// `s`: the placed derivatives there by the patch's parameters, mm, of first order or more.
    bool is_inside(std::uint32_t patch, const Vec2& uv, const SurfaceDerivatives& s);
    /// True if the place is material, or within the margin of a border. `s` as above.
    bool is_on(std::uint32_t patch, const Vec2& uv, const SurfaceDerivatives& s);

private:
    const TrimRegion& trims();
    ParameterMetric metric(std::uint32_t patch, const Vec2& uv, const SurfaceDerivatives& s) const;
    bool is_near_side(const Vec2& place, const ParameterMetric& metric) const;

    const SurfaceModel& model_;
    const Face& face_;
    double margin_;
    std::optional<TrimRegion> trims_; ///< made on first use
    Box2 domain_;                     ///< face parameters of all patches
};

/// The way of a border through a face that it meets at `hit`, `way` mm along the border.
struct BorderPassage {
    /// It leaves the tangent plane by more than half of `join` on both sides, within `join` / 2
    /// over sin `parallel_borders` of the hit.
    bool is_through = false;
    double length = 0; ///< mm of that way within `join` of the tangent plane
};

/// `join` in mm.
BorderPassage border_passage(const FreeEdge& border, double way, const Hit& hit, double join);

} // namespace keiko
