#pragma once

#include "keiko/light/rig/rig_light.h"
#include "keiko/light/rig/seen_light.h"
#include "keiko/visibility/query/occluders.h"

#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// The sources of a rig as lights that the surfaces of a scene stand in the way of.
class ShadowedRig {
public:
    /// Without occluders nothing casts shadows. All are only looked at.
    ShadowedRig(const LightRig& rig, const Occluders* occluders, const Tracer& tracer)
        : rig_(rig), occluders_(occluders), tracer_(tracer), lights_(lights_of(rig)) {}

    /// All of them, by source, then by lamp.
    const std::vector<RigLight>& lights() const { return lights_; }
    /// What a point with a unit normal on the side to be lit sees of some lights, by source, then
    /// by lamp; of a point on a surface, its own root. `axes`: see seen_lights(); rigs with a
    /// medium have them always.
    std::vector<SeenLight> seen_from(const Vec3& point, const Vec3& normal,
                                     const std::optional<Root>& root,
                                     std::span<const RigLight> lights, TubeModel model,
                                     bool axes = true) const;

    /// False where it is proved that all of the hull of `places` sees all of a light or nothing of
    /// it; see Occluders::may_come_between(). Windows are not looked into.
    bool may_come_between(std::span<const Vec3> places, const RigLight& light,
                          const std::optional<Vec3>& facing, TubeModel model) const;

private:
    const LightRig& rig_;
    const Occluders* occluders_;
    const Tracer& tracer_;
    std::vector<RigLight> lights_;
};

} // namespace keiko
