#include "keiko/light/tubes/stripe_coverage.h"

#include <algorithm>

namespace keiko {

double comb_coverage(const CPlaneFrame& frame, double strip_width, double center,
                     const PixelFilter& filter) {
    if (frame.lamps == 0) return 0;
    const double half = strip_width / 2;
    if (!(strip_width < frame.pitch))
        return filter.share(frame.first - half - center, frame.last() + half - center);
    const double reach = filter.reach() + half, last = frame.lamps - 1;
    const double lowest = std::ceil((center - reach - frame.first) / frame.pitch);
    const double highest = std::floor((center + reach - frame.first) / frame.pitch);
    const int begin = static_cast<int>(std::clamp(lowest, 0.0, last + 1));
    const int end = static_cast<int>(std::clamp(highest, -1.0, last));
    double sum = 0;
    for (int i = begin; i <= end; ++i) {
        const double at = frame.axis(i) - center;
        sum += filter.share(at - half, at + half);
    }
    return sum;
}

double mean_coverage(const CPlaneFrame& frame, double strip_width, double center,
                     const PixelFilter& filter) {
    if (frame.lamps == 0) return 0;
    const double half = std::max(frame.pitch, strip_width) / 2;
    return std::min(strip_width / frame.pitch, 1.0) *
           filter.share(frame.first - half - center, frame.last() + half - center);
}

} // namespace keiko
