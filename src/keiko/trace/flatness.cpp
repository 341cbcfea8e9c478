#include "keiko/trace/flatness.h"

#include <algorithm>
#include <limits>

namespace keiko {
namespace {

Vec3 euclidean(const BezierPatchView& patch, int i, int j) {
    const Vec4& p = patch.point(i, j);
    return Vec3(p.x, p.y, p.z) / p.w;
}

/// Largest second difference along lines of the net, as the sagitta of the arc they stand for.
double bend(const BezierPatchView& patch, bool along_u) {
    const int n = along_u ? patch.degree_u : patch.degree_v;
    const int lines = along_u ? patch.degree_v : patch.degree_u;
    const auto at = [&](int i, int line) {
        return along_u ? euclidean(patch, i, line) : euclidean(patch, line, i);
    };
    double most = 0;
    for (int line = 0; line <= lines; ++line)
        for (int i = 1; i < n; ++i)
            most = std::max(most, (at(i - 1, line) - at(i, line) * 2 + at(i + 1, line)).length());
    return most * n * (n - 1) / 8;
}

/// Affine map of [-1, 1]^2 through the middle of the corners.
struct Frame {
    Vec3 center, half_u, half_v;
};

Frame frame(const BezierPatchView& patch) {
    const Vec3 a = euclidean(patch, 0, 0), b = euclidean(patch, patch.degree_u, 0);
    const Vec3 c = euclidean(patch, 0, patch.degree_v);
    const Vec3 d = euclidean(patch, patch.degree_u, patch.degree_v);
    return {(a + b + c + d) / 4, (b + d - a - c) / 4, (c + d - a - b) / 4};
}

double deviation(const BezierPatchView& patch, const Frame& f) {
    const Vec3 normal = f.half_u.cross(f.half_v);
    const double area2 = normal.dot(normal);
    const double longest = std::max(f.half_u.length(), f.half_v.length());
    if (!(area2 > 1e-24 * longest * longest * longest * longest))
        return std::numeric_limits<double>::infinity();
    double most = 0;
    for (int i = 0; i <= patch.degree_u; ++i)
        for (int j = 0; j <= patch.degree_v; ++j) {
            const double x = 2.0 * i / patch.degree_u - 1, y = 2.0 * j / patch.degree_v - 1;
            const Vec3 e = euclidean(patch, i, j) - f.center - f.half_u * x - f.half_v * y;
            const double along_u = e.cross(f.half_v).dot(normal) / area2;
            const double along_v = f.half_u.cross(e).dot(normal) / area2;
            const double across = e.dot(normal) * longest / area2;
            most = std::max({most, std::abs(along_u), std::abs(along_v), std::abs(across)});
        }
    return most;
}

} // namespace

Flatness flatness(const BezierPatchView& patch) {
    const Frame f = frame(patch);
    const Vec3 twist = euclidean(patch, 0, 0) - euclidean(patch, patch.degree_u, 0) -
                       euclidean(patch, 0, patch.degree_v) +
                       euclidean(patch, patch.degree_u, patch.degree_v);
    return {.deviation = deviation(patch, f),
            .bend_u = bend(patch, true),
            .bend_v = bend(patch, false),
            .twist = twist.length() / 4,
            .length_u = 2 * f.half_u.length(),
            .length_v = 2 * f.half_v.length()};
}

} // namespace keiko
