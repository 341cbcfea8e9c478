#include "keiko/inspect/seams/run_out_places.h"

#include "keiko/geometry/model/closest_point.h"

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

RunOutPlaces::RunOutPlaces(std::span<const SeamProbe> pieces, const StretchLimits& limits) {
    for (const SeamStretch& stretch : seam_stretches(pieces, limits)) {
        if (stretch.kind != SeamClass::run_out) continue;
        for (const SeamPart& part : stretch.parts)
            run_outs_.push_back(pieces[part.piece].part(part.begin, part.end));
    }
}

bool RunOutPlaces::hold(const Vec3& place, double reach) const {
    return std::any_of(run_outs_.begin(), run_outs_.end(),
                       [&](const SeamProbe& probe) { return distance_to(probe, place) <= reach; });
}

} // namespace keiko
