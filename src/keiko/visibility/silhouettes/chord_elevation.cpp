#include "keiko/visibility/silhouettes/chord_elevation.h"

#include "keiko/geometry/bezier/subpatch.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Bounds of the derivatives along one parameter as viewed from a point.
struct DerivativeRange {
    double length = 0; ///< of the middle
    double off = 0;    ///< farthest from that middle, as a share of its length
    double rise = 0;   ///< largest component along the normal, likewise
    Vec3 middle{0};

    DerivativeRange(std::span<const Vec3> derivatives, const Vec3& normal) {
        Box3 box;
        for (const Vec3& d : derivatives) box.extend(d);
        middle = box.center();
        length = middle.length();
        for (const Vec3& d : derivatives) {
            off = std::max(off, (d - middle).length() / length);
            rise = std::max(rise, std::abs(normal.dot(d)) / length);
        }
    }
    DerivativeRange(const TangentBounds::Range& range, const Vec3& point, const Vec3& normal) {
        const Vec4 &m = range.middle, &h = range.half;
        middle = Vec3(m.x, m.y, m.z) - point * m.w;
        length = middle.length();
        const Vec3 half = Vec3(h.x, h.y, h.z) + magnitudes(point) * h.w;
        off = half.length() / length;
        rise = (std::abs(normal.dot(middle)) + magnitudes(normal).dot(half)) / length;
    }
};

TangentBounds::Range range_of(std::span<const Vec4> values) {
    Vec4 low(Box3::infinity), high(-Box3::infinity);
    for (const Vec4& v : values)
        for (unsigned k = 0; k < 4; ++k)
            low[k] = std::min(low[k], v[k]), high[k] = std::max(high[k], v[k]);
    return {(low + high) / 2, (high - low) / 2};
}

/// A chord is a (U + off) + b (V + off): Cauchy's inequality over its numerator and denominator.
double steepest(const DerivativeRange& u, const DerivativeRange& v) {
    const double cosine = std::abs(u.middle.dot(v.middle)) / (u.length * v.length);
    const double shortest = std::sqrt(1 - std::min(cosine, 1.0)) - std::hypot(u.off, v.off);
    constexpr double rounding = 1e-9;
    const double sine = std::hypot(u.rise, v.rise) / shortest + rounding;
    return shortest > 0 && sine < 1 ? sine : 1;
}

} // namespace

double least_elevation(const Viewpoint& viewpoint, const Vec3& normal,
                       std::span<const Vec3> corners) {
    double least = 1, above = 0;
    for (const Vec3& corner : corners) {
        const Vec3 way = viewpoint.way_to(corner);
        const double sine = normal.dot(way) / way.length();
        if (above == 0) above = sine < 0 ? -1 : 1;
        least = std::min(least, above * sine);
    }
    return std::max(least, 0.0);
}

TangentBounds tangent_bounds(const HomogeneousNet& net) {
    const auto columns = static_cast<std::size_t>(net.degree_v) + 1;
    std::vector<Vec4> along_u, along_v;
    for (std::size_t i = 0; i < net.points.size(); ++i) {
        if (i + columns < net.points.size())
            along_u.push_back(net.points[i + columns] - net.points[i]);
        if (i % columns + 1 < columns) along_v.push_back(net.points[i + 1] - net.points[i]);
    }
    return {range_of(along_u), range_of(along_v)};
}

double steepest_chord(const TangentBounds& bounds, const Vec3& point, const Vec3& normal) {
    return steepest({bounds.along_u, point, normal}, {bounds.along_v, point, normal});
}

double steepest_chord(const HomogeneousNet& points, const Box2& uv, const Vec3& point,
                      const Vec3& normal) {
    std::vector<Vec3> seen; // from the point, times a positive weight
    for (const Vec4& p : subpatch(points.view(), uv))
        seen.push_back(Vec3(p.x, p.y, p.z) - point * p.w);
    const auto columns = static_cast<std::size_t>(points.degree_v) + 1;
    std::vector<Vec3> along_u, along_v;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        if (i + columns < seen.size()) along_u.push_back(seen[i + columns] - seen[i]);
        if (i % columns + 1 < columns) along_v.push_back(seen[i + 1] - seen[i]);
    }
    return steepest({along_u, normal}, {along_v, normal});
}

} // namespace keiko
