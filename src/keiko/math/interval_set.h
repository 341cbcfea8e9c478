#pragma once

#include "keiko/base/export.h"

#include <array>
#include <cstddef>
#include <vector>

namespace KEIKO_API keiko {

/// Closed interval of a parameter.
struct ParameterInterval {
    double begin = 0, end = 0; ///< ends; begin <= end

    /// Length of the interval.
    double length() const { return end - begin; }
    bool operator==(const ParameterInterval&) const = default;
};

/// Sorted, disjoint intervals: the visible parts of a lamp, the lit parts of a view ray.
class IntervalSet {
public:
    IntervalSet() = default;
    /// Intervals in any order; overlapping and touching ones are joined, empty ones dropped.
    explicit IntervalSet(std::vector<ParameterInterval> intervals);
    /// The whole of [begin, end].
    static IntervalSet whole(double begin = 0, double end = 1) {
        IntervalSet set;
        if (begin < end) set.append({begin, end});
        return set;
    }
    /// From `a` at 0 to `b` at 1, sets of one size, interval by interval.
    static IntervalSet between(const IntervalSet& a, const IntervalSet& b, double at);

    /// True if it holds no interval.
    bool empty() const { return size() == 0; }
    /// The first interval; the others follow it.
    const ParameterInterval* begin() const { return many_.empty() ? few_.data() : many_.data(); }
    /// One past the last interval.
    const ParameterInterval* end() const { return begin() + size(); }
    /// Number of intervals.
    std::size_t size() const { return many_.empty() ? few_size_ : many_.size(); }
    /// Interval i, below size(), by rising parameter.
    const ParameterInterval& operator[](std::size_t i) const { return begin()[i]; }

    /// Sum of the lengths.
    double measure() const;
    /// True if a parameter lies in one of them.
    bool contains(double t) const;
    /// Intersection of both sets.
    IntervalSet intersect(const IntervalSet& other) const;
    /// Union of both sets.
    IntervalSet unite(const IntervalSet& other) const;
    /// The parts of [begin, end] that are not in this set.
    IntervalSet complement(double begin = 0, double end = 1) const;

    bool operator==(const IntervalSet&) const = default;

private:
    /// One beyond the others.
    void append(const ParameterInterval& last);

    // Most sets are of one interval or two, and pictures hold millions.
    std::size_t few_size_ = 0;
    std::array<ParameterInterval, 2> few_{}; ///< all, those beyond that size zero; or
    std::vector<ParameterInterval> many_;    ///< all, if they are more
};

} // namespace keiko
