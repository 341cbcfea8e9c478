#include "keiko/light/penumbra/width_samples.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Largest hidden part that agreeing lines may miss between them. Between such lines jumps up and
/// down have equal sums, so that the sum of jumps times places is independent of the reference
/// place. The sum of sizes is least about the place that has equal jumps on either side. At most
/// that much may jump up, or down, out of its place.
template <class Turns>
double missed_of(const Turns& turns) {
    double all = 0, up = 0, down = 0, before = 0, missed = 0;
    for (const auto& turn : turns) {
        all += turn.jump;
        if (turn.dark >= 0) up += turn.jump;
        if (turn.dark <= 0) down += turn.jump;
    }
    const auto middle = std::find_if(turns.begin(), turns.end(), [&](const auto& turn) {
        before += turn.jump;
        return before >= all / 2;
    });
    if (middle == turns.end()) return 0;
    for (const auto& turn : turns) missed += turn.jump * std::abs(turn.place - middle->place) / 2;
    return std::min(missed, std::min(up, down) * (turns.back().place - turns.front().place) / 2);
}

} // namespace

PenumbraBreakpoints::PenumbraBreakpoints(const SourceWidth& width,
                                         std::span<const CriticalSlice> turns, double spacing)
    : spacing_(spacing) {
    for (const CriticalSlice& turn : turns)
        if (const double place = width.place_in(turn.way); std::abs(place) < 1)
            turns_.push_back({place, turn.missed * 2 / spacing, turn.dark, turn.jump});
    std::sort(turns_.begin(), turns_.end(),
              [](const Turn& a, const Turn& b) { return a.place < b.place; });
}

/// Cells between the ends and the middles of the parts between cuts, on which nothing is missed.
std::vector<PenumbraBreakpoints::Cell> PenumbraBreakpoints::cells(
    std::span<const double> cuts) const {
    std::vector<Cell> cells;
    auto begin = turns_.begin();
    const auto add_to = [&](double place) {
        const auto end = std::find_if(begin, turns_.end(),
                                      [&](const Turn& turn) { return turn.place >= place; });
        if (end - begin > 1) cells.push_back({{begin, end}, missed_of(std::span(begin, end))});
        begin = end;
    };
    double last = -1;
    for (std::size_t i = 0; i <= cuts.size(); ++i) {
        const double next = i < cuts.size() ? cuts[i] : 1;
        add_to((last + next) / 2);
        add_to(next);
        while (begin != turns_.end() && begin->place <= next) ++begin;
        last = next;
    }
    return cells;
}

double PenumbraBreakpoints::missed(std::span<const double> cuts) const {
    double missed = 0;
    for (const Cell& cell : cells(cuts)) missed += cell.missed;
    return missed;
}

std::vector<double> PenumbraBreakpoints::places(double allowed, bool agree) const {
    std::vector<double> cuts;
    if (agree && missed(cuts) <= allowed) return cuts;
    constexpr double for_sure = 4; // less is left to the choice below, which needs fewer cuts
    const double told = agree ? for_sure * allowed : allowed;
    for (const Turn& turn : turns_)
        if (turn.jump * spacing_ / 2 > told) cuts.push_back(turn.place);
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    while (missed(cuts) > allowed) {
        const std::vector<Cell> cells = this->cells(cuts);
        const auto& turns =
            std::max_element(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) {
                return a.missed < b.missed;
            })->turns;
        const double place =
            std::max_element(turns.begin(), turns.end(), [](const Turn& a, const Turn& b) {
                return a.jump < b.jump;
            })->place;
        cuts.insert(std::lower_bound(cuts.begin(), cuts.end(), place), place);
    }
    return cuts;
}

bool PenumbraBreakpoints::jumps_at(double place) const {
    constexpr double one_place = 2e-5; // accuracy of the places of turns, of half the width
    return std::any_of(turns_.begin(), turns_.end(), [&](const Turn& turn) {
        return std::abs(turn.place - place) <= one_place && turn.at_once;
    });
}

/// Cuts that are close enough together for everything between them to be negligible are merged.
std::vector<WidthCut> PenumbraBreakpoints::cuts(double allowed, bool agree) const {
    std::vector<WidthCut> cuts;
    double left = allowed / 2; // of half the width, to be left out
    for (const double place : places(allowed, agree)) {
        const double between = cuts.empty() ? left : place - cuts.back().end;
        if (between < left)
            cuts.back() = {cuts.back().begin, place, true}, left -= between;
        else
            cuts.push_back({place, place, jumps_at(place)});
    }
    return cuts;
}

} // namespace keiko
