#include "keiko/render/shading/eye_probes.h"

#include <functional>
#include <utility>

namespace keiko {

std::size_t EyeProbes::PlaceHash::operator()(const Vec2& place) const {
    const std::hash<double> hash;
    return hash(place.x) * 31 + hash(place.y);
}

std::vector<const EyeSample*> EyeProbes::at(std::span<const Vec2> places) {
    Rays rays;
    rays.reserve(places.size());
    for (const Vec2& place : places) {
        rays.push_back(camera_.ray(place.x, place.y));
        rays.back().differentials.reset();
    }
    views_.push_back(integrator_.view(std::move(rays)));
    std::vector<const EyeSample*> samples;
    samples.reserve(places.size());
    for (const EyeSample& sample : views_.back().samples) samples.push_back(&sample);
    return samples;
}

std::vector<const EyeSample*> EyeProbes::shared_at(std::span<const Vec2> places) {
    std::vector<Vec2> unknown;
    std::vector<const EyeSample**> slots, empty;
    slots.reserve(places.size());
    for (const Vec2& place : places) {
        const auto [slot, is_new] = known_.try_emplace(place, nullptr);
        slots.push_back(&slot->second);
        if (is_new) unknown.push_back(place), empty.push_back(&slot->second);
    }
    const std::vector<const EyeSample*> found = at(unknown);
    for (std::size_t i = 0; i < unknown.size(); ++i) *empty[i] = found[i];
    std::vector<const EyeSample*> samples;
    samples.reserve(places.size());
    for (const EyeSample* const* slot : slots) samples.push_back(*slot);
    return samples;
}

PathCounts EyeProbes::paths() const {
    PathCounts counts;
    for (const EyeView& view : views_)
        for (const EyeSample& sample : view.samples) counts += sample.paths;
    return counts;
}

} // namespace keiko
