#include "keiko/import/cad/curve_spans.h"
#include "keiko/import/cad/trim_chains.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace keiko::cad {

namespace {

auto find(auto& repairs, RepairKind kind, const std::string& detail) {
    return std::find_if(repairs.begin(), repairs.end(), [&](const Repair& repair) {
        return repair.kind == kind && repair.detail == detail;
    });
}

} // namespace

void RepairLog::add(RepairKind kind, double size) {
    const auto known = find(repairs_, kind, "");
    if (known == repairs_.end()) {
        repairs_.push_back({0, kind, 1, size, ""});
        return;
    }
    ++known->count;
    known->size = std::max(known->size, size);
}

void RepairLog::add_remark(const std::string& words) {
    const auto known = find(repairs_, RepairKind::by_reader, words);
    if (known == repairs_.end())
        repairs_.push_back({0, RepairKind::by_reader, 1, 0, words});
    else
        ++known->count;
}

std::uint32_t RepairLog::count(RepairKind kind) const {
    std::uint32_t count = 0;
    for (const Repair& repair : repairs_) count += repair.kind == kind ? repair.count : 0;
    return count;
}

namespace {

Vec2 affine(const Vec3& p) {
    return Vec2(p.x, p.y) / p.z;
}

/// Whole periods nearest to `distance`, when they explain it: a rest of more than a twentieth
/// period is a real gap (a missing pole edge, say) that a shift would only move elsewhere.
double whole_periods(double distance, double period) {
    if (!(period > 0)) return 0;
    const double shift = std::round(distance / period) * period;
    return std::abs(distance - shift) < 0.05 * period ? shift : 0;
}

/// Extends the box by a curve whose ends it holds: halves it where its hull still sticks out.
void extend_tightly(Box2& box, const std::vector<Vec3>& points, int depth = 0) {
    constexpr double tightness = 1e-9;
    constexpr int deepest = 40;
    Box2 hull;
    for (const Vec3& p : points) hull.extend(affine(p));
    const Vec2 slack = box.extent() * tightness;
    const Box2 loose{box.lower - slack, box.upper + slack};
    if (points.size() == 2 || (loose.contains(hull.lower) && loose.contains(hull.upper)) ||
        depth == deepest) {
        box.extend(hull);
        return;
    }
    const auto halves = bernstein_parts(points);
    box.extend(affine(halves[0].back()));
    for (const auto& half : halves) extend_tightly(box, half, depth + 1);
}

Vec2 whole_periods(const Vec2& distance, const Vec2& period) {
    return {whole_periods(distance.x, period.x), whole_periods(distance.y, period.y)};
}

double gap_after_shift(const Vec2& from, const Vec2& to, const ParameterSpace& space) {
    return space.relative(from - to - whole_periods(from - to, space.period));
}

double worst_gap(const std::vector<Chain>& uses, const ParameterSpace& space) {
    double worst = 0;
    for (std::size_t i = 0; i < uses.size(); ++i)
        worst = std::max(
            worst, gap_after_shift(end_of(uses[i]), begin_of(uses[(i + 1) % uses.size()]), space));
    return worst;
}

double sum_of_gaps(const std::vector<Chain>& uses, const ParameterSpace& space) {
    double sum = 0;
    for (std::size_t i = 0; i < uses.size(); ++i)
        sum += gap_after_shift(end_of(uses[i]), begin_of(uses[(i + 1) % uses.size()]), space);
    return sum;
}

/// Whether two uses of one edge meet a whole period apart: at a pole whose own edge is missing.
bool missing_pole(const Chain& from, const Chain& to, const ParameterSpace& space) {
    const Vec2 gap = end_of(from) - begin_of(to);
    const std::uint32_t edge = from.back().edge;
    return edge != no_index && edge == to.front().edge &&
           space.relative(whole_periods(gap, space.period)) > small_gap &&
           gap_after_shift(end_of(from), begin_of(to), space) <= small_gap;
}

/// Joins uses in their order into one chain.
Chain joined(std::vector<Chain> uses, const ParameterSpace& space, RepairLog& log) {
    const bool pole_at_end = uses.size() > 1 && missing_pole(uses.back(), uses.front(), space);
    Chain chain = std::move(uses.front());
    for (Chain& use : std::span(uses).subspan(1)) {
        const bool pole = missing_pole(chain, use, space);
        const Vec2 offset = whole_periods(end_of(chain) - begin_of(use), space.period);
        if (offset != Vec2(0) && !pole) {
            shift(use, offset);
            log.add(RepairKind::p_curve_moved);
        }
        const Vec2 from = end_of(chain), to = begin_of(use);
        if (pole)
            log.add(RepairKind::degenerate_edge_added);
        else if (space.relative(to - from) > small_gap)
            log.add(RepairKind::gap_bridged, space.distance(from, to));
        if (space.relative(to - from) > small_gap) chain.push_back(connector(from, to));
        chain.insert(chain.end(), use.begin(), use.end());
    }
    if (pole_at_end && end_of(chain) != begin_of(chain)) {
        chain.push_back(connector(end_of(chain), begin_of(chain)));
        log.add(RepairKind::degenerate_edge_added);
    }
    return chain;
}

/// The uses rearranged so that each begins where another ended, as several rings if need be.
std::vector<std::vector<Chain>> sorted(std::vector<Chain> uses, const ParameterSpace& space) {
    std::vector<std::vector<Chain>> rings;
    while (!uses.empty()) {
        std::vector<Chain> ring{std::move(uses.front())};
        uses.erase(uses.begin());
        while (!uses.empty()) {
            const Vec2 end = end_of(ring.back());
            const auto nearest =
                std::min_element(uses.begin(), uses.end(), [&](const Chain& a, const Chain& b) {
                    return gap_after_shift(end, begin_of(a), space) <
                           gap_after_shift(end, begin_of(b), space);
                });
            const double closing = gap_after_shift(end, begin_of(ring.front()), space);
            if (closing < gap_after_shift(end, begin_of(*nearest), space)) break;
            ring.push_back(std::move(*nearest));
            uses.erase(nearest);
        }
        rings.push_back(std::move(ring));
    }
    return rings;
}

/// Reverses uses one by one wherever that makes the widest gap smaller and the others no wider;
/// returns how many.
int reverse_backward_uses(std::vector<Chain>& ring, const ParameterSpace& space) {
    int reversed = 0;
    for (std::size_t i = 0; i < ring.size() && ring.size() > 1; ++i) {
        const double before = worst_gap(ring, space), sum_before = sum_of_gaps(ring, space);
        reverse(ring[i]);
        if (worst_gap(ring, space) < before && sum_of_gaps(ring, space) < sum_before)
            ++reversed;
        else
            reverse(ring[i]);
    }
    return reversed;
}

} // namespace

double ParameterSpace::relative(const Vec2& gap) const {
    return std::max(std::abs(gap.x) / scale.x, std::abs(gap.y) / scale.y);
}

double ParameterSpace::distance(const Vec2& a, const Vec2& b) const {
    return point ? (point(b) - point(a)).length() : (b - a).length();
}

Vec2 begin_of(const Chain& chain) {
    return affine(chain.front().points.front());
}
Vec2 end_of(const Chain& chain) {
    return affine(chain.back().points.back());
}

void shift(Chain& chain, const Vec2& offset) {
    for (LoopCurve& curve : chain)
        for (Vec3& p : curve.points) p += Vec3(offset.x, offset.y, 0) * p.z;
}

void reverse(Chain& chain) {
    std::reverse(chain.begin(), chain.end());
    for (LoopCurve& curve : chain) std::reverse(curve.points.begin(), curve.points.end());
}

LoopCurve connector(const Vec2& from, const Vec2& to) {
    return {{Vec3(from.x, from.y, 1), Vec3(to.x, to.y, 1)}, no_index};
}

Box2 tight_bounds(const Chain& chain) {
    Box2 box;
    for (const LoopCurve& curve : chain) {
        box.extend(affine(curve.points.front()));
        box.extend(affine(curve.points.back()));
    }
    for (const LoopCurve& curve : chain) extend_tightly(box, curve.points);
    return box;
}

std::vector<Chain> chain_wire(std::vector<Chain> uses, const ParameterSpace& space,
                              RepairLog& log) {
    if (uses.empty()) return {};
    std::vector<Chain> chains;
    if (!(worst_gap(uses, space) > small_gap)) {
        chains.push_back(joined(std::move(uses), space, log));
        return chains;
    }
    auto rings = sorted(uses, space);
    double worst_sorted = 0;
    for (const auto& ring : rings) worst_sorted = std::max(worst_sorted, worst_gap(ring, space));
    if (worst_sorted < worst_gap(uses, space))
        log.add(RepairKind::edges_sorted);
    else
        rings = {std::move(uses)};
    for (auto& ring : rings) {
        for (int i = reverse_backward_uses(ring, space); i > 0; --i)
            log.add(RepairKind::edge_reversed);
        chains.push_back(joined(std::move(ring), space, log));
    }
    if (chains.size() > 1) log.add(RepairKind::wire_split);
    return chains;
}

} // namespace keiko::cad
