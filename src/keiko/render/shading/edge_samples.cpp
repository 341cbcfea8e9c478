#include "keiko/render/shading/edge_samples.h"

#include <functional>
#include <utility>

namespace keiko {

std::size_t EdgeSamples::PlaceHash::operator()(const Vec2& place) const {
    const std::hash<double> hash;
    return hash(place.x) * 31 + hash(place.y);
}

std::vector<const PixelSample*> EdgeSamples::at(std::span<const Vec2> places) {
    Rays rays;
    rays.reserve(places.size());
    for (const Vec2& place : places) {
        rays.push_back(camera_.ray(place.x, place.y));
        rays.back().differentials.reset();
    }
    views_.push_back(integrator_.view(std::move(rays)));
    std::vector<const PixelSample*> samples;
    samples.reserve(places.size());
    for (const PixelSample& sample : views_.back().samples) samples.push_back(&sample);
    return samples;
}

std::vector<const PixelSample*> EdgeSamples::shared_at(std::span<const Vec2> places) {
    std::vector<Vec2> unknown;
    std::vector<const PixelSample**> slots, empty;
    slots.reserve(places.size());
    for (const Vec2& place : places) {
        const auto [slot, is_new] = known_.try_emplace(place, nullptr);
        slots.push_back(&slot->second);
        if (is_new) unknown.push_back(place), empty.push_back(&slot->second);
    }
    const std::vector<const PixelSample*> found = at(unknown);
    for (std::size_t i = 0; i < unknown.size(); ++i) *empty[i] = found[i];
    std::vector<const PixelSample*> samples;
    samples.reserve(places.size());
    for (const PixelSample* const* slot : slots) samples.push_back(*slot);
    return samples;
}

HitStatistics EdgeSamples::paths() const {
    HitStatistics counts;
    for (const SampleBatch& view : views_)
        for (const PixelSample& sample : view.samples) counts += sample.paths;
    return counts;
}

} // namespace keiko
