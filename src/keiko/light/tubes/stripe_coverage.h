#pragma once

#include "keiko/light/tubes/c_plane_frame.h"

#include <algorithm>
#include <cmath>

namespace keiko {

/// What a pixel's square becomes along one axis of the C-plane when the map from picture to plane
/// is linear across the pixel: two boxes of widths |du/dx| and |du/dy| folded together, a
/// trapezoid of unit area. Both widths 0: a point.
class PixelFilter {
public:
    /// Widths in mm, of either sign.
    PixelFilter(double by_x, double by_y)
        : wide_(std::max(std::abs(by_x), std::abs(by_y))),
          narrow_(std::min(std::abs(by_x), std::abs(by_y))) {}

    /// Share of the filter that lies in [begin, end], positions relative to its centre; 0 to 1.
    double share(double begin, double end) const {
        return begin < end ? below(end) - below(begin) : 0;
    }
    /// Nothing of it is farther from the centre, mm.
    double reach() const { return (wide_ + narrow_) / 2; }
    double width() const { return wide_; }

private:
    /// Integral of the filter up to x.
    double below(double x) const { return 0.5 + std::copysign(half(std::abs(x)), x); }
    /// Its integral from 0 to x >= 0.
    double half(double x) const {
        if (x >= reach()) return 0.5;
        if (x <= reach() - narrow_) return x / wide_;
        const double rest = reach() - x;
        return 0.5 - rest * rest / (2 * wide_ * narrow_);
    }

    double wide_, narrow_;
};

/// Share of a filter centred at v = `center` mm that falls on the comb's strips of `strip_width`
/// mm, 0 to 1: exact for any filter (docs/theory.md#stripes-without-noise). Strips that overlap
/// count as one.
double comb_coverage(const CPlaneFrame& frame, double strip_width, double center,
                     const PixelFilter& filter);

/// The same for stripes too fine to be told apart: the comb as a grey band.
double mean_coverage(const CPlaneFrame& frame, double strip_width, double center,
                     const PixelFilter& filter);

} // namespace keiko
