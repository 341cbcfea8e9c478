#include "keiko/volumes/scene_volumes.h"

#include "keiko/math/reach.h"
#include "keiko/volumes/ray_samples.h"

namespace keiko {

SceneVolumes::SceneVolumes(std::span<const VolumeSpec> specs, const Job& job) {
    for (const VolumeSpec& spec : specs) volumes_.emplace_back(spec, job);
}

std::vector<Box3> SceneVolumes::boxes() const {
    std::vector<Box3> boxes;
    for (const Volume& volume : volumes_) boxes.push_back(volume.bounds());
    return boxes;
}

double SceneVolumes::reach_from(const Vec3& place) const {
    return keiko::reach_from(place, boxes());
}

double SceneVolumes::optical_depth(const Segment& segment, double most) const {
    double depth = 0;
    for (const Volume& volume : volumes_) {
        const auto ray = volume.crossing(segment);
        if (!ray) continue;
        const RaySamples samples(ray->begin, ray->end, volume.step());
        samples.each([&](double t) { return volume.clear_until(*ray, t); },
                     [&](double t) {
                         depth += volume.extinction(ray->at(t)) * samples.length();
                         return depth <= most;
                     });
    }
    return depth;
}

} // namespace keiko
