#pragma once

#include "keiko/base/export.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace KEIKO_API keiko {

/// A range of real numbers. Every operation returns a range that holds all exact results: ends are
/// moved outwards by more than the rounding of the operation.
struct Interval {
    double low = 0, high = 0; ///< ends; low <= high

    Interval() = default;
    /// A single number.
    constexpr Interval(double value) : low(value), high(value) {}
    /// The numbers between two ends.
    constexpr Interval(double from, double to) : low(from), high(to) {}

    /// Middle of the range.
    double middle() const { return low + (high - low) / 2; }
    /// Largest absolute value.
    double magnitude() const { return std::max(std::abs(low), std::abs(high)); }
    /// True if 0 lies in it.
    bool holds_zero() const { return !(low > 0 || high < 0); }
    /// The range with a margin on both sides.
    Interval padded(double margin) const { return {low - margin, high + margin}; }
    /// The common part of both; the ends may cross where rounding parted two ranges of one number.
    Interval intersection(const Interval& other) const {
        return {std::max(low, other.low), std::min(high, other.high)};
    }
};

namespace interval_rounding {
constexpr double relative = std::numeric_limits<double>::epsilon(); ///< share of an end
constexpr double absolute = std::numeric_limits<double>::min();     ///< beside that

/// The range with both ends moved outwards by more than a rounding.
inline Interval outward(double low, double high) {
    return {low - (std::abs(low) * relative + absolute),
            high + (std::abs(high) * relative + absolute)};
}
} // namespace interval_rounding

/// Range of -a.
inline Interval operator-(const Interval& a) {
    return {-a.high, -a.low};
}
/// Range of a + b.
inline Interval operator+(const Interval& a, const Interval& b) {
    return interval_rounding::outward(a.low + b.low, a.high + b.high);
}
/// Range of a - b.
inline Interval operator-(const Interval& a, const Interval& b) {
    return interval_rounding::outward(a.low - b.high, a.high - b.low);
}
/// Range of a b.
inline Interval operator*(const Interval& a, const Interval& b) {
    const double p = a.low * b.low, q = a.low * b.high, r = a.high * b.low, s = a.high * b.high;
    return interval_rounding::outward(std::min(std::min(p, q), std::min(r, s)),
                                      std::max(std::max(p, q), std::max(r, s)));
}
/// Everything where the divisor holds 0.
inline Interval operator/(const Interval& a, const Interval& b) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (b.holds_zero()) return {-infinity, infinity};
    return a * interval_rounding::outward(1 / b.high, 1 / b.low);
}
/// Negative numbers count as 0: they are what rounding made of a sum of squares.
inline Interval sqrt(const Interval& a) {
    return interval_rounding::outward(std::sqrt(std::max(0.0, a.low)),
                                      std::sqrt(std::max(0.0, a.high)));
}
/// Range of a^2.
inline Interval square(const Interval& a) {
    const double p = a.low * a.low, q = a.high * a.high;
    return interval_rounding::outward(a.low < 0 && a.high > 0 ? 0 : std::min(p, q), std::max(p, q));
}

/// Least and largest of many numbers. Several are kept side by side, so that no comparison waits
/// for the one before it.
class RunningRange {
public:
    /// Range of no numbers.
    RunningRange() {
        low_.fill(std::numeric_limits<double>::infinity());
        high_.fill(-std::numeric_limits<double>::infinity());
    }
    /// Adds value(0) to value(count - 1).
    template <class Value>
    void add(std::size_t count, const Value& value) {
        std::size_t i = 0;
        for (; i + lanes <= count; i += lanes)
            for (std::size_t k = 0; k < lanes; ++k) add_to(k, value(i + k));
        for (; i < count; ++i) add_to(i % lanes, value(i));
    }
    /// The least number so far; infinity if none.
    double low() const { return *std::min_element(low_.begin(), low_.end()); }
    /// The largest number so far; -infinity if none.
    double high() const { return *std::max_element(high_.begin(), high_.end()); }

private:
    static constexpr std::size_t lanes = 4;

    void add_to(std::size_t k, double x) {
        low_[k] = x < low_[k] ? x : low_[k];
        high_[k] = x > high_[k] ? x : high_[k];
    }

    std::array<double, lanes> low_, high_;
};

} // namespace keiko
