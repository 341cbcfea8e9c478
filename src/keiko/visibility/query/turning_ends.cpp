#include "keiko/visibility/query/contour_extrema.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace keiko {

/// A line runs on where one part goes up from a place and one down, but for how it bends there.
std::vector<ContourExtrema::Turn> ContourExtrema::turning_ends() const {
    std::vector<Turn> turns;
    std::vector<End> ends = ends_;
    std::sort(ends.begin(), ends.end(),
              [](const End& a, const End& b) { return a.across < b.across; });
    for (std::size_t i = 0; i < ends.size(); ++i) {
        if (std::isnan(ends[i].along)) continue;
        int rise = 0;
        double bend = 0, weight = 0;
        bool whole = false, jump = false;
        int dark = ends[i].dark;
        for (std::size_t k = i; k < ends.size() && ends[k].across <= ends[i].across + one_place;
             ++k) {
            if (!(std::abs(ends[k].along - ends[i].along) <= one_place_along)) continue;
            rise += ends[k].rise, bend += ends[k].rise * ends[k].slope;
            weight += ends[k].weight, whole = whole || ends[k].whole;
            jump = jump || ends[k].jump;
            if (ends[k].dark != dark) dark = 0;
            if (k > i) ends[k].along = std::nan("");
        }
        if (rise == 0) weight = std::min(weight, kink(std::abs(bend)));
        if (whole || std::abs(rise) != 1) turns.push_back({ends[i].across, weight, dark, jump});
    }
    return turns;
}

/// Two faces of one edge have it twice.
std::vector<ContourExtrema::Turn> ContourExtrema::all_turns() const {
    std::vector<Turn> turns = turning_ends();
    turns.insert(turns.end(), turns_.begin(), turns_.end());
    std::sort(turns.begin(), turns.end(), [](const Turn& a, const Turn& b) {
        return std::pair(a.across, a.missed) < std::pair(b.across, b.missed);
    });
    const auto is_same = [](const Turn& a, const Turn& b) {
        return b.across - a.across <= one_place && a.jump == b.jump &&
               std::abs(a.missed - b.missed) <= 1e-3 * a.missed;
    };
    turns.erase(std::unique(turns.begin(), turns.end(), is_same), turns.end());
    return turns;
}

std::vector<ContourExtrema::Turn> ContourExtrema::found() const {
    std::vector<Turn> turns = all_turns();
    std::sort(turns.begin(), turns.end(),
              [](const Turn& a, const Turn& b) { return a.missed < b.missed; });
    double missed = left_out_;
    const auto matters = [&](const Turn& turn) { return (missed += turn.missed) > missed_; };
    turns.erase(turns.begin(), std::find_if(turns.begin(), turns.end(), matters));
    for (Turn& turn : turns) turn.across = prism_.across_low + turn.across * width_;
    return turns;
}

} // namespace keiko
