#include "keiko/inspect/overlaps/border_passage.h"

#include "keiko/geometry/seam/border_run.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// The place of a border, which goes round where it is closed.
Vec3 place_at(const FreeEdge& border, double way) {
    const double all = border.length();
    if (border.closed) way = std::fmod(std::fmod(way, all) + all, all);
    return border.at(std::clamp(way, 0.0, all)).position;
}

} // namespace

BorderPassage border_passage(const FreeEdge& border, double way, const Hit& hit, double join) {
    constexpr int steps = 16; // on either side
    const double step = join / 2 / std::sin(parallel_borders) / steps;
    BorderPassage passage;
    double least_before = 0, most_before = 0, least_after = 0, most_after = 0;
    for (int i = -steps; i <= steps; ++i) {
        const Vec3 off = place_at(border, way + i * step) - hit.position;
        const double offset = off.dot(hit.normal);
        if (i < steps && std::abs(offset) <= join) passage.length += step;
        double& least = i < 0 ? least_before : least_after;
        double& most = i < 0 ? most_before : most_after;
        least = std::min(least, offset), most = std::max(most, offset);
    }
    passage.is_through = (least_before < -join / 2 && most_after > join / 2) ||
                         (most_before > join / 2 && least_after < -join / 2);
    return passage;
}

} // namespace keiko
