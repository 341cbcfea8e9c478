#pragma once

#include "keiko/intersect/traversal/tracer.h"
#include "keiko/light/rig/prepared_rig.h"
#include "keiko/math/rgb.h"
#include "keiko/scene/material.h"

#include <optional>
#include <span>

namespace keiko {

/// Loss of the light of lamps in the glass of a scene, along straight ways: Fresnel's loss
/// at each interface, and absorption inside (docs/theory/glass.md#shadows). Light is not bent.
class GlassLoss {
public:
    /// `materials`: one a face of the tracer's model. Keeps references to both. With `caustics`
    /// solid glass lets no light of points and suns straight on: Caustics have it.
    GlassLoss(const Tracer& tracer, std::span<const Material> materials, bool caustics = false);

    /// False where there is no glass.
    bool any() const { return any_; }
    /// Share by channel, 0 to 1, of the light of a lamp of a source that reaches a point. It is the
    /// mean over its lamp_places(). `root`: of the point, on a surface.
    Rgb left(const PreparedSource& source, int lamp, const Vec3& point,
             const std::optional<Root>& root) const;

private:
    /// `towards`: from the point to the lamp, mm. `bent`: the light is that of caustics.
    Rgb left_along(const Vec3& point, const std::optional<Root>& root, const Vec3& towards,
                   bool bent) const;
    /// Share that the ways inside solid glass leave; `solid`: its interfaces, by rising t.
    Rgb left_inside(std::span<const Hit* const> solid, double length) const;

    const Tracer& tracer_;
    std::span<const Material> materials_;
    bool any_, caustics_;
};

} // namespace keiko
