#include "keiko/render/antialias/edge_samples.h"

#include <array>
#include <functional>
#include <map>
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

namespace {

/// px: accuracy of the place of a crossing.
constexpr double nearness = 1.0 / 64;

bool is_open(const EdgeCrossing& side) {
    return side.state == EdgeCrossing::State::crossed && side.length() > nearness;
}

void close_in(EdgeSamples& probes, std::span<EdgeCrossing> sides) {
    while (true) {
        std::vector<Vec2> middles;
        for (const EdgeCrossing& side : sides)
            if (is_open(side)) middles.push_back(side.middle());
        if (middles.empty()) return;
        const std::vector<const PixelSample*> seen = probes.shared_at(middles);
        auto next = seen.begin();
        for (EdgeCrossing& side : sides)
            if (is_open(side)) side.halve(**next++);
    }
}

} // namespace

std::vector<EdgeCrossing> outline_crossings(EdgeSamples& probes, std::span<const SeenCell> cells) {
    std::vector<EdgeCrossing> sides, found;
    std::map<std::array<double, 4>, std::size_t> known;
    std::vector<std::size_t> places;
    for (const SeenCell& seen : cells)
        for (const std::size_t i : seen.crossed_sides) {
            sides.push_back(seen.side(i));
            const EdgeCrossing upright = sides.back().upright();
            const std::array key{upright.a.x, upright.a.y, upright.b.x, upright.b.y};
            const auto [place, is_new] = known.emplace(key, found.size());
            places.push_back(place->second);
            if (is_new) found.push_back(upright);
        }
    close_in(probes, found);
    for (std::size_t i = 0; i < sides.size(); ++i) sides[i].take(found[places[i]]);
    return sides;
}

} // namespace keiko
