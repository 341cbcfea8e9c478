#include "keiko/render/eye_probes.h"

namespace keiko {

std::vector<const EyeSample*> EyeProbes::at(std::span<const Vec2> places) {
    std::vector<Ray> rays;
    rays.reserve(places.size());
    for (const Vec2& place : places) {
        rays.push_back(camera_.ray(place.x, place.y));
        rays.back().differentials.reset();
    }
    views_.push_back(integrator_.view(rays));
    std::vector<const EyeSample*> samples;
    samples.reserve(places.size());
    for (const EyeSample& sample : views_.back().samples) samples.push_back(&sample);
    return samples;
}

std::vector<const EyeSample*> EyeProbes::shared_at(std::span<const Vec2> places) {
    std::vector<Vec2> unknown;
    for (const Vec2& place : places)
        if (known_.emplace(std::pair(place.x, place.y), nullptr).second) unknown.push_back(place);
    const std::vector<const EyeSample*> found = at(unknown);
    for (std::size_t i = 0; i < unknown.size(); ++i)
        known_[{unknown[i].x, unknown[i].y}] = found[i];
    std::vector<const EyeSample*> samples;
    samples.reserve(places.size());
    for (const Vec2& place : places) samples.push_back(known_[{place.x, place.y}]);
    return samples;
}

PathCounts EyeProbes::paths() const {
    PathCounts counts;
    for (const EyeView& view : views_)
        for (const EyeSample& sample : view.samples) counts += sample.paths;
    return counts;
}

} // namespace keiko
