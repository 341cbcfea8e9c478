#include "keiko/trace/chord_elevation.h"

#include "keiko/trace/subpatch.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Where the derivatives along one parameter are.
struct DerivativeRange {
    double length = 0; ///< of the middle of their box
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
};

} // namespace

double least_elevation(const Apex& apex, const Vec3& normal, std::span<const Vec3> corners) {
    double least = 1, above = 0;
    for (const Vec3& corner : corners) {
        const Vec3 way = apex.way_to(corner);
        const double sine = normal.dot(way) / way.length();
        if (above == 0) above = sine < 0 ? -1 : 1;
        least = std::min(least, above * sine);
    }
    return std::max(least, 0.0);
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
    const DerivativeRange u(along_u, normal), v(along_v, normal);
    // A chord is a (U + off) + b (V + off): Cauchy's inequality over its numerator and denominator.
    const double cosine = std::abs(u.middle.dot(v.middle)) / (u.length * v.length);
    const double shortest = std::sqrt(1 - std::min(cosine, 1.0)) - std::hypot(u.off, v.off);
    constexpr double rounding = 1e-9;
    const double steepest = std::hypot(u.rise, v.rise) / shortest + rounding;
    return shortest > 0 && steepest < 1 ? steepest : 1;
}

} // namespace keiko
