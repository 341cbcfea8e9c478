#pragma once

#include "keiko/intersect/traversal/tracer.h"
#include "keiko/math/rgb.h"
#include "keiko/scene/material.h"

#include <optional>
#include <span>

namespace keiko {

/// Loss of the light of lamps in the glass of a scene, along straight ways: Fresnel's loss
/// at each interface, and absorption inside (docs/theory/glass.md#shadows). Light is not bent.
class GlassLoss {
public:
    /// `materials`: one a face of the tracer's model. Keeps references to both.
    GlassLoss(const Tracer& tracer, std::span<const Material> materials);

    /// False where there is no glass.
    bool any() const { return any_; }
    /// Share by channel, 0 to 1, of a lamp's light that reaches a point: the mean over a grid of
    /// places between its `corners`, which are those of lamp_corners(). There are 8 on a segment,
    /// 4 x 4 in a rectangle and 2 x 2 x 2 in a box. `root`: of the point, on a surface.
    Rgb left(const Vec3& point, const std::optional<Root>& root,
             std::span<const Vec3> corners) const;

private:
    Rgb left_along(const Ray& way) const;

    const Tracer& tracer_;
    std::span<const Material> materials_;
    bool any_;
};

} // namespace keiko
