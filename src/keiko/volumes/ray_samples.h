#pragma once

#include <algorithm>
#include <cmath>

namespace keiko {

/// Samples in the middle of equal steps along a part of a ray, mm; none is farther than `step` from
/// the next.
class RaySamples {
public:
    /// Samples from `begin` to a larger `end`.
    RaySamples(double begin, double end, double step) : begin_(begin) {
        count_ = std::ceil((end - begin) / step - 1e-9); // not one more for a rounded length
        length_ = (end - begin) / count_;
    }

    /// Length of a step.
    double length() const { return length_; }
    /// Calls `visit` at each sample in order until it returns false, except at those before
    /// `clear_until` of an earlier one.
    template <class ClearUntil, class Visit>
    void each(const ClearUntil& clear_until, const Visit& visit) const {
        double number = 0;
        while (number < count_) {
            const double t = begin_ + (number + 0.5) * length_;
            const double clear = clear_until(t);
            if (clear > t) {
                number = std::max(number + 1, std::ceil((clear - begin_) / length_ - 0.5));
                continue;
            }
            if (!visit(t)) return;
            ++number;
        }
    }

private:
    double begin_, length_ = 0, count_ = 0;
};

} // namespace keiko
