#include "keiko/math/interval_set.h"

#include <algorithm>

namespace keiko {

IntervalSet::IntervalSet(std::vector<ParameterInterval> intervals) {
    std::erase_if(intervals, [](const ParameterInterval& i) { return !(i.begin < i.end); });
    std::sort(intervals.begin(), intervals.end(),
              [](const auto& a, const auto& b) { return a.begin < b.begin; });
    std::size_t kept = 0;
    for (const ParameterInterval& next : intervals) {
        if (kept > 0 && next.begin <= intervals[kept - 1].end)
            intervals[kept - 1].end = std::max(intervals[kept - 1].end, next.end);
        else
            intervals[kept++] = next;
    }
    intervals.resize(kept);
    intervals_ = std::move(intervals);
}

double IntervalSet::measure() const {
    double sum = 0;
    for (const ParameterInterval& i : intervals_) sum += i.length();
    return sum;
}

bool IntervalSet::contains(double t) const {
    const auto after = std::upper_bound(intervals_.begin(), intervals_.end(), t,
                                        [](double x, const auto& i) { return x < i.begin; });
    return after != intervals_.begin() && t <= std::prev(after)->end;
}

IntervalSet IntervalSet::intersect(const IntervalSet& other) const {
    std::vector<ParameterInterval> common;
    for (auto a = begin(), b = other.begin(); a != end() && b != other.end();) {
        common.push_back({std::max(a->begin, b->begin), std::min(a->end, b->end)});
        a->end < b->end ? ++a : ++b;
    }
    return IntervalSet(std::move(common));
}

IntervalSet IntervalSet::unite(const IntervalSet& other) const {
    std::vector<ParameterInterval> both = intervals_;
    both.insert(both.end(), other.begin(), other.end());
    return IntervalSet(std::move(both));
}

IntervalSet IntervalSet::complement(double begin, double end) const {
    std::vector<ParameterInterval> gaps;
    double from = begin;
    for (const ParameterInterval& i : intervals_) {
        gaps.push_back({from, std::min(i.begin, end)});
        from = std::max(from, i.end);
    }
    gaps.push_back({from, end});
    return IntervalSet(std::move(gaps));
}

} // namespace keiko
