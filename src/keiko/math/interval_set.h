#pragma once

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
        return IntervalSet({{begin, end}});
    }

    bool empty() const { return intervals_.empty(); }
    auto begin() const { return intervals_.begin(); }
    auto end() const { return intervals_.end(); }
    std::size_t size() const { return intervals_.size(); }
    const ParameterInterval& operator[](std::size_t i) const { return intervals_[i]; }

    /// Sum of the lengths.
    double measure() const;
    bool contains(double t) const;
    IntervalSet intersect(const IntervalSet& other) const;
    IntervalSet unite(const IntervalSet& other) const;
    /// What of [begin, end] is not in this set.
    IntervalSet complement(double begin = 0, double end = 1) const;

    bool operator==(const IntervalSet&) const = default;

private:
    std::vector<ParameterInterval> intervals_;
};

} // namespace keiko
