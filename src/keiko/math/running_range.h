#pragma once

#include <algorithm>
#include <array>
#include <limits>

namespace keiko {

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
