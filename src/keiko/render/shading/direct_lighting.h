#pragma once

#include "keiko/light/rig/light_id.h"
#include "keiko/light/rig/light_visibility.h"
#include "keiko/visibility/query/occluders.h"

#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// The sources of a rig as lights that the surfaces of a scene stand in the way of.
class DirectLighting {
public:
    /// Without occluders nothing casts shadows. All are only looked at.
    DirectLighting(const LightRig& rig, const Occluders* occluders, const Tracer& tracer)
        : rig_(rig), occluders_(occluders), tracer_(tracer), lights_(lights_of(rig)) {}

    /// All of them, by source, then by lamp.
    const std::vector<LightId>& lights() const { return lights_; }
    /// What a point with a unit normal on the side to be lit sees of some lights, by source, then
    /// by lamp; of a point on a surface, its own root. `axes`: see light_visibilities(); rigs with
    /// a medium have them always.
    std::vector<LightVisibility> light_visibility(const Vec3& point, const Vec3& normal,
                                                  const std::optional<Root>& root,
                                                  std::span<const LightId> lights, TubeModel model,
                                                  bool axes = true) const;

    /// False where it is proved that all of the hull of `places` sees all of a light or nothing of
    /// it; see Occluders::may_occlude(). Windows are not looked into.
    bool may_occlude(std::span<const Vec3> places, const LightId& light,
                     const std::optional<Vec3>& facing, TubeModel model) const;

private:
    const LightRig& rig_;
    const Occluders* occluders_;
    const Tracer& tracer_;
    std::vector<LightId> lights_;
};

} // namespace keiko
