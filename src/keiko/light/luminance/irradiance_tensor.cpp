#include "keiko/light/luminance/irradiance_tensor.h"

#include <cmath>
#include <vector>

namespace keiko {
namespace {

/// Solid angle of a triangle of unit directions, signed by their order [VanOosterom1983].
double solid_angle(const Vec3& p, const Vec3& q, const Vec3& r) {
    return 2 * std::atan2(p.dot(q.cross(r)), 1 + p.dot(q) + q.dot(r) + r.dot(p));
}

} // namespace

double second_irradiance_moment(std::span<const Vec3> corners, const Vec3& a, const Vec3& b) {
    if (corners.size() < 3) return 0;
    std::vector<Vec3> w;
    for (const Vec3& corner : corners) w.push_back(corner.normalized());
    double whole = 0, boundary = 0;
    for (std::size_t i = 1; i + 1 < w.size(); ++i) whole += solid_angle(w[0], w[i], w[i + 1]);
    for (std::size_t i = 0; i < w.size(); ++i) {
        const Vec3 &from = w[i], &to = w[(i + 1) % w.size()];
        const Vec3 plane = from.cross(to);
        const double sine = plane.length();
        if (!(sine > 0)) continue;
        const Vec3 inward = plane / sine; // the integral of w along the arc is across it
        boundary += a.dot((to - from).cross(inward)) * b.dot(inward);
    }
    return (a.dot(b) * whole + boundary) / 3 * (whole < 0 ? -1 : 1);
}

} // namespace keiko
