#include "keiko/render/antialias/edge_detection.h"
#include "keiko/render/antialias/edge_refinement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

namespace keiko {

namespace {

bool is_upright(const Vec2& a, const Vec2& b) {
    return a.x + a.y < b.x + b.y; // sides run along an axis of the picture
}

EdgeCrossing turned(EdgeCrossing side) {
    std::swap(side.a, side.b);
    std::swap(side.at_a, side.at_b);
    return side;
}

} // namespace

EdgeCrossing EdgeCrossing::upright() const {
    return is_upright(a, b) ? *this : turned(*this);
}

void EdgeCrossing::take(const EdgeCrossing& upright) {
    const std::size_t number = side;
    *this = is_upright(a, b) ? upright : turned(upright);
    side = number;
}

void EdgeCrossing::halve(const PixelSample& seen) {
    const bool like_a = !differ_closely(*at_a, seen), like_b = !differ_closely(seen, *at_b);
    if (like_a == like_b) state = like_a ? State::bent : State::tangled;
    (like_a ? a : b) = middle();
    (like_a ? at_a : at_b) = &seen;
}

namespace {

/// Contrast allowed in a pixel, as a share of the larger luminance.
constexpr double least_contrast = 0.01;

/// Difference of two samples from samples of one plane.
double change(const PixelSample& a, const PixelSample& b) {
    constexpr double outline = 4; // more than any turn
    if (differ_closely(a, b)) return outline;
    return a.hit ? a.hit->normal.cross(b.hit->normal).length() : 0;
}

} // namespace

std::array<EdgeCell, 2> EdgeCell::halves(unsigned axis) const {
    Vec2 step(0), half = size;
    half[axis] /= 2;
    step[axis] = half[axis];
    return {EdgeCell{pixel, corner, half, nullptr}, EdgeCell{pixel, corner + step, half, nullptr}};
}

SeenCell::SeenCell(const EdgeCell& seen, std::span<const PixelSample* const, 4> around)
    : cell(seen) {
    std::copy(around.begin(), around.end(), corners.begin());
    for (std::size_t i = 0; i < 4; ++i)
        if (differ_closely(*corners[i], *corners[(i + 1) % 4])) crossed_sides.push_back(i);
}

EdgeCrossing SeenCell::side(std::size_t i) const {
    const auto places = cell.corners();
    const std::size_t end = (i + 1) % 4;
    return {i, places[i], places[end], corners[i], corners[end]};
}

bool SeenCell::looks_like(const PixelSample& sample) const {
    const double contrast = least_contrast / cell.area();
    return std::all_of(corners.begin(), corners.end(), [&](const PixelSample* corner) {
        return look_alike(*corner, sample, contrast) && !differ(*corner, sample);
    });
}

SampledPolygon SeenCell::part() const {
    SampledPolygon part;
    for (const Vec2& place : cell.corners()) part.corners.push_back(place);
    for (const PixelSample* corner : corners) part.seen.push_back(corner);
    return part;
}

unsigned SeenCell::most_varied_axis(double finest) const {
    const Vec2& size = cell.size;
    if (!(size.x > finest)) return 1;
    if (!(size.y > finest)) return 0;
    const double across = change(*corners[0], *corners[1]) + change(*corners[3], *corners[2]);
    const double down = change(*corners[0], *corners[3]) + change(*corners[1], *corners[2]);
    if (across == down) return size.y > size.x ? 1 : 0;
    return down > across ? 1 : 0;
}

namespace {

/// Largest distance of an edge from the line between its crossings, as a share of the cell's mean
/// side.
constexpr double slack = 0.1;

/// Part of a cell between two crossings, counted around the cell.
CutPart part_between(const SeenCell& seen, const EdgeCrossing& begin, const EdgeCrossing& end) {
    const auto corners = seen.cell.corners();
    // The sample at the far end of the first side's crossing is in the part, and so is the one at
    // the near end of the last one's.
    SampledPolygon part;
    const auto add = [&](const Vec2& corner, const PixelSample* sample) {
        part.corners.push_back(corner), part.seen.push_back(sample);
    };
    add(begin.middle(), begin.at_b);
    for (std::size_t i = begin.side; i != end.side; i = (i + 1) % 4)
        add(corners[(i + 1) % 4], seen.corners[(i + 1) % 4]);
    add(end.middle(), end.at_a);
    const Vec2 cut = (begin.middle() + end.middle()) / 2;
    const Vec2 step = part.whole().centre - cut;
    const double farthest = slack * std::sqrt(seen.cell.area()) / step.length();
    return {part, cut + step * std::min(farthest, 1.0)};
}

} // namespace

ClippedCell::ClippedCell(const SeenCell& cell, const EdgeCrossing& first,
                         const EdgeCrossing& second)
    : seen(cell), parts{part_between(cell, first, second), part_between(cell, second, first)} {}

bool ClippedCell::holds_centre() const {
    if (!seen.cell.centre) return true;
    const Vec2 centre = seen.cell.corner + seen.cell.size / 2;
    const auto off = [&](const CutPart& part) { return (part.beside_cut - centre).length2(); };
    return parts[off(parts[0]) < off(parts[1]) ? 0 : 1].seen.shows(*seen.cell.centre);
}

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
