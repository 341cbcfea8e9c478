#include "keiko/geometry/seam/border_approach.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {

bool nearly_parallel(const Vec3& a, const Vec3& b, double sine) {
    const Vec3 c = a.cross(b);
    return c.dot(c) <= sine * sine * a.dot(a) * b.dot(b);
}

namespace {

/// Box of a chord.
Box3 box_of(const CurvePolyline& line, std::size_t chord) {
    Box3 box;
    box.extend(line.points[chord]);
    box.extend(line.points[chord + 1]);
    return box;
}

} // namespace

BorderApproach border_approach(const CurvePolyline& a, const CurvePolyline& b, double join) {
    const double reach = join + a.deviation + b.deviation;
    const Box3 box = b.box().padded(join + a.deviation);
    // Twice the turns, as they are estimates.
    const double between = std::min(parallel_borders + 2 * (a.turn + b.turn), std::numbers::pi / 2);
    const double sin_between = std::sin(between);
    BorderApproach result;
    std::vector<ParameterInterval> close;
    for (std::size_t i = 0; i + 1 < a.points.size(); ++i) {
        if (!box_of(a, i).overlaps(box)) continue;
        const Box3 segment = box_of(a, i).padded(reach);
        const Vec3 along = a.points[i + 1] - a.points[i];
        for (std::size_t j = 0; j + 1 < b.points.size(); ++j) {
            const Vec3 other_along = b.points[j + 1] - b.points[j];
            if (!segment.overlaps(box_of(b, j)) ||
                !nearly_parallel(along, other_along, sin_between))
                continue;
            const SegmentApproach nearest =
                segment_approach(a.points[i], a.points[i + 1], b.points[j], b.points[j + 1]);
            if (nearest.distance > reach) continue;
            if (close.empty() || close.back().begin != a.t[i])
                close.push_back({a.t[i], a.t[i + 1]});
            if (nearest.share > 0 && nearest.share < 1)
                result.nearest.push_back(a.t[i] + nearest.share * (a.t[i + 1] - a.t[i]));
        }
    }
    result.close = IntervalSet(std::move(close));
    std::sort(result.nearest.begin(), result.nearest.end());
    return result;
}

} // namespace keiko
