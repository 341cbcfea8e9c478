#include "keiko/math/interval_set.h"

#include <algorithm>

namespace keiko {

IntervalSet::IntervalSet(std::vector<ParameterInterval> intervals) {
    std::erase_if(intervals, [](const ParameterInterval& i) { return !(i.begin < i.end); });
    std::sort(intervals.begin(), intervals.end(),
              [](const auto& a, const auto& b) { return a.begin < b.begin; });
    for (std::size_t i = 0; i < intervals.size();) {
        ParameterInterval joined = intervals[i++];
        while (i < intervals.size() && intervals[i].begin <= joined.end)
            joined.end = std::max(joined.end, intervals[i++].end);
        append(joined);
    }
}

void IntervalSet::append(const ParameterInterval& last) {
    if (many_.empty() && few_size_ < few_.size()) {
        few_[few_size_++] = last;
        return;
    }
    if (many_.empty()) many_.assign(few_.begin(), few_.end());
    few_ = {}, few_size_ = 0;
    many_.push_back(last);
}

IntervalSet IntervalSet::between(const IntervalSet& a, const IntervalSet& b, double at) {
    const auto mix = [&](double from, double to) { return from + (to - from) * at; };
    IntervalSet set;
    for (std::size_t i = 0; i < a.size(); ++i)
        set.append({mix(a[i].begin, b[i].begin), mix(a[i].end, b[i].end)});
    return set;
}

double IntervalSet::measure() const {
    double sum = 0;
    for (const ParameterInterval& i : *this) sum += i.length();
    return sum;
}

bool IntervalSet::contains(double t) const {
    const auto* after =
        std::upper_bound(begin(), end(), t, [](double x, const auto& i) { return x < i.begin; });
    return after != begin() && t <= std::prev(after)->end;
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
    std::vector<ParameterInterval> both(begin(), end());
    both.insert(both.end(), other.begin(), other.end());
    return IntervalSet(std::move(both));
}

IntervalSet IntervalSet::complement(double begin, double end) const {
    std::vector<ParameterInterval> rest;
    double from = begin;
    for (const ParameterInterval& i : *this) {
        rest.push_back({from, std::min(i.begin, end)});
        from = std::max(from, i.end);
    }
    rest.push_back({from, end});
    return IntervalSet(std::move(rest));
}

} // namespace keiko
