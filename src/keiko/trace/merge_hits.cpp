#include "keiko/trace/merge_hits.h"

#include <algorithm>

namespace keiko {
namespace {

bool same_point(const BorderHit& a, const BorderHit& b, double speed) {
    if (!(a.at_border && b.at_border) || a.hit.instance != b.hit.instance) return false;
    const double reach = a.hit.position_bound + b.hit.position_bound + a.seam_reach + b.seam_reach;
    return (b.hit.t - a.hit.t) * speed <= reach &&
           (b.hit.position - a.hit.position).length() <= 2 * reach;
}

} // namespace

std::vector<Hit> merged(std::vector<BorderHit> hits, double speed) {
    std::vector<BorderHit> kept;
    for (BorderHit& next : hits) {
        const auto twin = std::find_if(kept.rbegin(), kept.rend(), [&](const BorderHit& k) {
            return same_point(k, next, speed);
        });
        if (twin == kept.rend())
            kept.push_back(std::move(next));
        else if (has(twin->hit.flags, HitFlags::seam) && !has(next.hit.flags, HitFlags::seam))
            *twin = std::move(next);
    }
    std::vector<Hit> result;
    for (BorderHit& k : kept) result.push_back(std::move(k.hit));
    std::stable_sort(result.begin(), result.end(),
                     [](const Hit& a, const Hit& b) { return a.t < b.t; });
    return result;
}

} // namespace keiko
