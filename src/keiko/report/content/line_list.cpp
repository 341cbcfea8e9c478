#include "keiko/report/content/line_list.h"

#include <algorithm>

namespace keiko {

CrossingCounts count_crossings(const LineList& list) {
    CrossingCounts counts;
    for (const ViewLines& view : list.views)
        for (const LineCrossing& crossing : view.found.crossings) {
            if (!crossing.verdict)
                ++counts.not_judged;
            else if (*crossing.verdict == Verdict::fail)
                ++counts.fail;
            else
                ++(*crossing.verdict == Verdict::pass ? counts.pass : counts.undecided);
        }
    return counts;
}

Verdict verdict_of(const LineList& list) {
    const CrossingCounts counts = count_crossings(list);
    if (counts.fail > 0) return Verdict::fail;
    return counts.undecided > 0 ? Verdict::undecided : Verdict::pass;
}

std::vector<CrossingPlace> ranked_crossings(const LineList& list) {
    std::vector<CrossingPlace> places;
    for (std::size_t v = 0; v < list.views.size(); ++v)
        for (std::size_t c = 0; c < list.views[v].found.crossings.size(); ++c)
            if (list.views[v].found.crossings[c].verdict) places.push_back({v, c});
    std::stable_sort(places.begin(), places.end(),
                     [&](const CrossingPlace& a, const CrossingPlace& b) {
                         const LineCrossing &of_a = a.in(list), &of_b = b.in(list);
                         if (*of_a.verdict != *of_b.verdict) return *of_a.verdict > *of_b.verdict;
                         return of_a.severity > of_b.severity;
                     });
    return places;
}

} // namespace keiko
