#include "keiko/placement/stripe_statistics.h"

#include "keiko/placement/plane_frame.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace keiko {
namespace {

struct Spacing {
    double pixels = 0, weight = 0;
};

/// From stripe to stripe where a sample mirrors the lamps; nothing where it does not.
std::optional<double> spacing_at(const ViewSample& sample, const CPlane& plane) {
    const auto hit = meet(frame_of(plane), sample.mirror);
    const Box2 lamps{Vec2(0), Vec2(plane.u.length(), plane.v.length())};
    if (!hit || hit->cosine < grazing_cosine || !lamps.contains(hit->place) || !hit->gradients)
        return {};
    const double gradient = hit->gradients->v.length();
    if (!(gradient > 0) || !std::isfinite(gradient)) return {};
    return plane.spacing() / gradient;
}

std::vector<Spacing> spacings(std::span<const ViewSample> samples, std::span<const CPlane> planes) {
    std::vector<Spacing> found;
    for (const ViewSample& sample : samples) {
        if (sample.blocked) continue;
        for (const CPlane& plane : planes)
            if (const auto pixels = spacing_at(sample, plane)) {
                found.push_back({*pixels, sample.weight});
                break;
            }
    }
    std::sort(found.begin(), found.end(),
              [](const Spacing& a, const Spacing& b) { return a.pixels < b.pixels; });
    return found;
}

/// The spacing below which `share` of the weight lies, of sorted spacings.
double quantile(std::span<const Spacing> sorted, double total, double share) {
    double sum = 0;
    for (const Spacing& s : sorted)
        if ((sum += s.weight) >= share * total) return s.pixels;
    return 0;
}

} // namespace

StripeStatistics stripe_statistics(std::span<const ViewSample> samples,
                                   std::span<const CPlane> planes, const StripeSpacing& wanted) {
    const std::vector<Spacing> sorted = spacings(samples, planes);
    double total = 0, in_range = 0, log_sum = 0, log_squares = 0;
    for (const Spacing& s : sorted) {
        const double log_spacing = std::log(s.pixels);
        total += s.weight;
        log_sum += s.weight * log_spacing;
        log_squares += s.weight * log_spacing * log_spacing;
        if (wanted.least <= s.pixels && s.pixels <= wanted.most) in_range += s.weight;
    }
    if (!(total > 0)) return {};
    const double mean = log_sum / total;
    return {.narrow = quantile(sorted, total, 0.1),
            .median = quantile(sorted, total, 0.5),
            .wide = quantile(sorted, total, 0.9),
            .in_range = in_range / total,
            .uniformity = std::exp(-std::sqrt(std::max(0.0, log_squares / total - mean * mean)))};
}

} // namespace keiko
