#pragma once

#include "keiko/light/rig/glossy_luminance.h"
#include "keiko/light/rig/illuminance.h"
#include "keiko/light/rig/light_id.h"

#include <span>
#include <vector>

namespace keiko {

/// A point of a surface or in space under lights of a rig of which it is known what it sees.
class PointLighting {
public:
    /// Unit normal on the side to be lit; `lights` by source, then by lamp; `seen` of each, as
    /// DirectLighting::light_visibility has it for the same model. Rig and lights are only looked
    /// at.
    PointLighting(const LightRig& rig, const Vec3& point, const Vec3& normal, TubeModel model,
                  std::span<const LightId> lights, std::vector<LightVisibility> seen)
        : rig_(rig),
          point_(point),
          normal_(normal),
          model_(model),
          lights_(lights),
          seen_(std::move(seen)) {}

    /// lx from each light, in order.
    std::vector<Rgb> illuminance_by_light(const ClearCoat* coat = nullptr) const;
    /// cd/m2 that the lobe of a kernel, made for the point's normal, sends to its eye of each
    /// light.
    template <class Kernel>
    std::vector<Rgb> glossy_by_light(const Kernel& kernel) const {
        return by_light([&](const LightSource& source, std::span<const int> lamps,
                            std::span<const LightVisibility> seen) {
            return glossy_luminance_by_lamp(source, lamps, seen, rig_.medium, point_, kernel);
        });
    }

private:
    /// What `of_source` of a source, some of its lamps and what is seen of them comes to.
    template <class OfSource>
    std::vector<Rgb> by_light(const OfSource& of_source) const {
        std::vector<Rgb> all;
        all.reserve(lights_.size());
        each_source(
            lights_, [&](std::size_t source, std::span<const int> lamps, std::size_t first) {
                for (const Rgb& value : of_source(rig_.sources[source], lamps,
                                                  std::span(seen_).subspan(first, lamps.size())))
                    all.push_back(value);
            });
        return all;
    }

    const LightRig& rig_;
    Vec3 point_, normal_;
    TubeModel model_;
    std::span<const LightId> lights_;
    std::vector<LightVisibility> seen_;
};

} // namespace keiko
