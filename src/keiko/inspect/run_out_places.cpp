#include "keiko/inspect/run_out_places.h"

#include "keiko/patch/curve_polyline.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// mm from a place to side a of a seam, by 64 chords.
double distance_to(const SeamProbe& probe, const Vec3& place) {
    constexpr int steps = 64;
    double least = HUGE_VAL;
    Vec3 before = probe.place(probe.begin());
    for (int i = 1; i <= steps; ++i) {
        const double t = probe.begin() + (probe.end() - probe.begin()) * i / steps;
        const Vec3 after = probe.place(t);
        least = std::min(least, segment_distance(before, after, place));
        before = after;
    }
    return least;
}

} // namespace

const std::vector<SeamProbe>& RunOutPlaces::run_outs_of(std::uint32_t chain) {
    const auto [at, is_new] = found_.try_emplace(chain);
    if (!is_new) return at->second;
    std::vector<SeamProbe> probes;
    for (const std::uint32_t piece : chains_[chain]) probes.emplace_back(curves_, seams_[piece]);
    for (const SeamStretch& stretch : seam_stretches(probes, limits_)) {
        if (stretch.kind != SeamClass::run_out) continue;
        for (const SeamPart& part : stretch.parts)
            at->second.push_back(probes[part.piece].part(part.begin, part.end));
    }
    return at->second;
}

bool RunOutPlaces::hold(std::uint32_t chain, const Vec3& place, double reach) {
    const std::vector<SeamProbe>& run_outs = run_outs_of(chain);
    return std::any_of(run_outs.begin(), run_outs.end(),
                       [&](const SeamProbe& probe) { return distance_to(probe, place) <= reach; });
}

} // namespace keiko
