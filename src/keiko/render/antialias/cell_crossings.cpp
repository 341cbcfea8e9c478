#include "keiko/render/antialias/cell_crossings.h"

#include <array>
#include <map>

namespace keiko {
namespace {

/// px: how near the place of a crossing is known.
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
