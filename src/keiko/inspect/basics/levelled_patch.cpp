#include "keiko/inspect/basics/levelled_patch.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Ratio of the weights of neighbouring control points that makes a row run as fast at its end as
/// at its beginning; at most a factor of 4 over the whole row.
double evening_ratio(const BezierPatchView& patch, bool along_u) {
    const int degree = along_u ? patch.degree_u : patch.degree_v;
    const int rows = along_u ? patch.degree_v : patch.degree_u;
    const auto at = [&](int k, int row) {
        return along_u ? patch.point(k, row) : patch.point(row, k);
    };
    const auto speed = [&](const Vec4& end, const Vec4& next) {
        return (Vec3(next.x, next.y, next.z) - Vec3(end.x, end.y, end.z) * (next.w / end.w))
                   .length() /
               end.w;
    };
    double first = 0, last = 0;
    for (int row = 0; row <= rows; ++row) {
        first += speed(at(0, row), at(1, row));
        last += speed(at(degree, row), at(degree - 1, row));
    }
    const double most = std::pow(4.0, 1.0 / degree);
    if (!(first > 0 && last > 0)) return 1;
    return std::clamp(std::sqrt(last / first), 1 / most, most);
}

/// The patch reparametrised so that its parameters run more uniformly. Replacing u by r u / (1 + (r
/// - 1) u) keeps every point on the surface and multiplies control points by powers of r
/// [Patterson1985].
std::vector<Vec4> evened(const BezierPatchView& patch) {
    std::vector<Vec4> points(patch.points.begin(), patch.points.end());
    if (!patch.rational()) return points;
    const double ratio_u = evening_ratio(patch, true), ratio_v = evening_ratio(patch, false);
    std::size_t index = 0;
    double row = 1;
    for (int i = 0; i <= patch.degree_u; ++i, row *= ratio_u) {
        double factor = row;
        for (int j = 0; j <= patch.degree_v; ++j, factor *= ratio_v) points[index++] *= factor;
    }
    return points;
}

/// Moves a patch to its centre and turns it so that its tangents there lie in the plane z = 0. The
/// ranges of a small piece then depend on its curvature, not on its position and orientation in
/// space.
void level(const BezierPatchView& patch, std::vector<Vec4>& points) {
    const SurfaceDerivatives s = evaluate({patch.degree_u, patch.degree_v, points}, {0.5, 0.5}, 1);
    const Vec3 n = s.du().cross(s.dv());
    if (!(n.length() > 0)) return;
    const Vec3 x = s.du().normalized(), z = n.normalized(), y = z.cross(x);
    for (Vec4& p : points) {
        const Vec3 from_centre = Vec3(p.x, p.y, p.z) - s.position() * p.w;
        p = Vec4(from_centre.dot(x), from_centre.dot(y), from_centre.dot(z), p.w);
    }
}

/// Rounding error of the control points of a levelled patch, mm.
double rounding_of(const BezierPatchView& patch, const std::vector<Vec4>& points, double given) {
    constexpr double relative_rounding = 1e-14;
    double extent = 0, weight = 0, weight_before = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec4 &p = points[i], &q = patch.points[i];
        extent = std::max({extent, std::abs(p.x), std::abs(p.y), std::abs(p.z), std::abs(q.x),
                           std::abs(q.y), std::abs(q.z)});
        weight = std::max(weight, p.w), weight_before = std::max(weight_before, q.w);
    }
    const double growth = weight / weight_before;
    return (relative_rounding * extent + given) * std::max(1.0, growth);
}

} // namespace

LevelledPatch::LevelledPatch(const BezierPatchView& patch, double rounding)
    : degree_u_(patch.degree_u), degree_v_(patch.degree_v), points_(evened(patch)) {
    level(patch, points_);
    rounding_ = rounding_of(patch, points_, rounding);
}

} // namespace keiko
