#include "keiko/inspect/seams/facing_chords.h"

#include "keiko/geometry/seam/border_approach.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Shares s at which low <= from + s * slope <= high.
ParameterInterval between(double from, double slope, double low, double high) {
    if (slope == 0)
        return low <= from && from <= high ? ParameterInterval{0, 1} : ParameterInterval{1, 0};
    const auto [begin, end] = std::minmax({(low - from) / slope, (high - from) / slope});
    return {begin, end};
}

/// Shares s at which |from + s * slope| <= reach.
ParameterInterval within(const Vec3& from, const Vec3& slope, double reach) {
    const double a = slope.length2(), b = from.dot(slope), c = from.length2() - reach * reach;
    if (a == 0) return c <= 0 ? ParameterInterval{0, 1} : ParameterInterval{1, 0};
    const double square = b * b - a * c;
    if (!(square >= 0)) return {1, 0};
    return {(-b - std::sqrt(square)) / a, (-b + std::sqrt(square)) / a};
}

} // namespace

std::optional<ParameterInterval> part_beside(const Chord& chord, const Chord& other, double reach) {
    const double length = other.length();
    const Vec3 way = chord.to - chord.from;
    if (!(length > 0) || !nearly_parallel(way, other.to - other.from, std::sin(parallel_borders)))
        return std::nullopt;
    const Vec3 along = (other.to - other.from) / length;
    const Vec3 start = chord.from - other.from;
    const ParameterInterval on = between(start.dot(along), way.dot(along), 0, length);
    const ParameterInterval near =
        within(start - along * start.dot(along), way - along * way.dot(along), reach);
    const ParameterInterval part{std::max({0.0, on.begin, near.begin}),
                                 std::min({1.0, on.end, near.end})};
    return part.begin < part.end ? std::optional(part) : std::nullopt;
}

} // namespace keiko
