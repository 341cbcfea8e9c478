#include "keiko/inspect/curvature/parabolic_rate.h"

#include <cmath>

namespace keiko {

// K = (L N - M M) / (E G - F F), so that at K = 0 only the numerator's slopes count. With second
// forms of the normal's length n = |Su x Sv|, K = D / n^4. The other curvature is that of 2 H.
double parabolic_rate(const SurfaceDerivatives& s) {
    const auto d = [&s](std::size_t k, std::size_t l) -> const Vec3& { return s.d[k][l]; };
    const Vec3 normal = s.du().cross(s.dv());
    const Vec3 normal_u = s.duu().cross(s.dv()) + s.du().cross(s.duv());
    const Vec3 normal_v = s.duv().cross(s.dv()) + s.du().cross(s.dvv());
    const double l = s.duu().dot(normal), m = s.duv().dot(normal), n = s.dvv().dot(normal);
    const double by_u = (d(3, 0).dot(normal) + s.duu().dot(normal_u)) * n +
                        l * (d(1, 2).dot(normal) + s.dvv().dot(normal_u)) -
                        2 * m * (d(2, 1).dot(normal) + s.duv().dot(normal_u));
    const double by_v = (d(2, 1).dot(normal) + s.duu().dot(normal_v)) * n +
                        l * (d(0, 3).dot(normal) + s.dvv().dot(normal_v)) -
                        2 * m * (d(1, 2).dot(normal) + s.duv().dot(normal_v));
    const double e = s.du().dot(s.du()), f = s.du().dot(s.dv()), g = s.dv().dot(s.dv());
    const double area2 = normal.dot(normal);
    const double other = std::abs(l * g - 2 * m * f + n * e) / (area2 * std::sqrt(area2));
    const double slope =
        std::sqrt((e * by_v * by_v - 2 * f * by_u * by_v + g * by_u * by_u) / area2) /
        (area2 * area2);
    const double rate = slope / other;
    return std::isfinite(rate) ? rate : 0;
}

} // namespace keiko
