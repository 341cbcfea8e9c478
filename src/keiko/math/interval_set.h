#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace keiko {

/// Closed interval of a parameter.
struct ParameterInterval {
    double begin = 0, end = 0;

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

    bool empty() const { return size() == 0; }
    const ParameterInterval* begin() const { return many_.empty() ? few_.data() : many_.data(); }
    const ParameterInterval* end() const { return begin() + size(); }
    std::size_t size() const { return many_.empty() ? few_size_ : many_.size(); }
    const ParameterInterval& operator[](std::size_t i) const { return begin()[i]; }

    /// Sum of the lengths.
    double measure() const;
    bool contains(double t) const;
    IntervalSet intersect(const IntervalSet& other) const;
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
