#include "keiko/geometry/seam/seam_offer.h"

#include "keiko/math/bounds.h"

#include <algorithm>

namespace keiko {

double cost(const FacingPoints& p) {
    constexpr double overlap_penalty = 4;
    return p.overlap ? overlap_penalty * p.distance : p.distance;
}

namespace {

/// Value at a parameter of the border, interpolated between the points of an offer; infinity beyond
/// its ends and beside points that do not count.
template <class Counts, class Value>
double between(const SeamOffer& offer, double x, const Counts& counts, const Value& value) {
    const auto& points = offer.candidate->stretch.points;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const FacingPoints &p = points[i], &q = points[i + 1];
        const double x0 = offer.parameter(p), x1 = offer.parameter(q);
        if (!(std::min(x0, x1) <= x && x <= std::max(x0, x1))) continue;
        if (!counts(p) || !counts(q)) continue;
        const double share = x1 != x0 ? (x - x0) / (x1 - x0) : 0;
        return value(p) + share * (value(q) - value(p));
    }
    return Box3::infinity;
}

} // namespace

double cost_at(const SeamOffer& offer, double x) {
    return between(
        offer, x, [](const FacingPoints&) { return true; }, cost);
}

double width_at(const SeamOffer& offer, double x) {
    return between(
        offer, x, [](const FacingPoints& p) { return p.overlap; },
        [](const FacingPoints& p) { return p.distance; });
}

} // namespace keiko
