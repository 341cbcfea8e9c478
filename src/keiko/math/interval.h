#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace keiko {

/// A range of real numbers. Every operation returns a range that holds all exact results: ends are
/// moved outwards by more than the rounding of the operation.
struct Interval {
    double low = 0, high = 0;

    Interval() = default;
    constexpr Interval(double value) : low(value), high(value) {}
    constexpr Interval(double from, double to) : low(from), high(to) {}

    double middle() const { return low + (high - low) / 2; }
    /// Largest absolute value.
    double magnitude() const { return std::max(std::abs(low), std::abs(high)); }
    bool holds_zero() const { return !(low > 0 || high < 0); }
    Interval padded(double margin) const { return {low - margin, high + margin}; }
    /// The common part of both; the ends may cross where rounding parted two ranges of one number.
    Interval intersection(const Interval& other) const {
        return {std::max(low, other.low), std::min(high, other.high)};
    }
};

namespace interval_rounding {
constexpr double relative = std::numeric_limits<double>::epsilon();
constexpr double absolute = std::numeric_limits<double>::min();

inline Interval outward(double low, double high) {
    return {low - (std::abs(low) * relative + absolute),
            high + (std::abs(high) * relative + absolute)};
}
} // namespace interval_rounding

inline Interval operator-(const Interval& a) {
    return {-a.high, -a.low};
}
inline Interval operator+(const Interval& a, const Interval& b) {
    return interval_rounding::outward(a.low + b.low, a.high + b.high);
}
inline Interval operator-(const Interval& a, const Interval& b) {
    return interval_rounding::outward(a.low - b.high, a.high - b.low);
}
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
inline Interval square(const Interval& a) {
    const double p = a.low * a.low, q = a.high * a.high;
    return interval_rounding::outward(a.low < 0 && a.high > 0 ? 0 : std::min(p, q), std::max(p, q));
}

/// Least and largest of many numbers. Several are kept side by side, so that no comparison waits
/// for the one before it.
class RunningRange {
public:
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
    double low() const { return *std::min_element(low_.begin(), low_.end()); }
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
