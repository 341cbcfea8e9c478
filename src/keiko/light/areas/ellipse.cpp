#include "keiko/light/areas/ellipse.h"

#include "keiko/light/areas/area_irradiance.h"
#include "keiko/math/axes.h"
#include "keiko/math/symmetric_eigen.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keiko {
namespace {

/// The circle of a disc.
Ellipse ellipse_of(const Vec3& center, const Vec3& normal, double radius) {
    const Vec3 p = any_perpendicular(normal).normalized();
    return {center, p * radius, normal.cross(p) * radius};
}

/// Principal axes of the cone x^2 / mu_1 + y^2 / mu_2 + z^2 / mu_3 >= 0 over an ellipse.
struct ConeAxes {
    std::array<Vec3, 3> axes{Vec3(0), Vec3(0), Vec3(0)}; ///< unit
    std::array<double, 3> mu{};                          ///< first > 0 > third >= second
};

/// By the dual cone c c^T - p p^T - q q^T, c the way to the center. In a frame along c its small
/// eigenvalues keep their digits, as Jacobi's rotations of a graded matrix do.
ConeAxes cone_axes(const Vec3& c, const Vec3& p, const Vec3& q) {
    const Vec3 ahead = c.normalized(), across = any_perpendicular(ahead).normalized();
    const std::array frame{ahead, across, ahead.cross(across)};
    SquareMatrix<3> dual{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            dual[i][k] = -p.dot(frame[i]) * p.dot(frame[k]) - q.dot(frame[i]) * q.dot(frame[k]);
    dual[0][0] += c.length2();
    const SymmetricEigen<3> eigen = symmetric_eigen(dual);
    std::array<std::size_t, 3> order{0, 1, 2}; // the positive one, then from the least
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        const double of_a = eigen.values[a], of_b = eigen.values[b];
        return (of_a > 0) != (of_b > 0) ? of_a > 0 : of_a < of_b;
    });
    ConeAxes cone;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto& row = eigen.vectors[order[k]];
        cone.mu[k] = eigen.values[order[k]];
        cone.axes[k] = frame[0] * row[0] + frame[1] * row[1] + frame[2] * row[2];
    }
    if (cone.axes[0].dot(c) < 0) cone.axes[0] = -cone.axes[0];
    return cone;
}

} // namespace

Ellipse outline_ellipse(const DiscLight& light, const Vec3& /*point*/) {
    return ellipse_of(light.center, light.normal, light.radius);
}

Ellipse outline_ellipse(const SphereLight& light, const Vec3& point) {
    const Disc outline = outline_of(light, point);
    return ellipse_of(outline.center, outline.normal, outline.radius);
}

/// The outline of a sphere about 0 of radius 1, mapped to the ellipsoid.
Ellipse outline_ellipse(const EllipsoidLight& light, const Vec3& point) {
    const Vec3 eye = light.in_sphere(point - light.center);
    const Disc outline = outline_of(SphereLight{Vec3(0), 1}, eye);
    const Ellipse circle = ellipse_of(outline.center, outline.normal, outline.radius);
    const auto map = [&](const Vec3& at) {
        return light.u * at.x + light.v * at.y + light.w * at.z;
    };
    return {light.center + map(circle.center), map(circle.p), map(circle.q)};
}

Disc circular_section(const Ellipse& ellipse, const Vec3& point) {
    const ConeAxes cone = cone_axes(ellipse.center - point, ellipse.p, ellipse.q);
    // The cone is l1 x^2 - l2 y^2 - l3 z^2 >= 0 with l3 >= l2 > 0. The plane alpha x + beta z = 1
    // cuts it in a circle, as it cuts a sphere through the point.
    const double l1 = 1 / cone.mu[0], l2 = -1 / cone.mu[1], l3 = -1 / cone.mu[2];
    const double alpha = std::sqrt(l1 + l2), beta = std::sqrt(l3 - l2), all = l1 + l3;
    const Vec3 &x = cone.axes[0], &z = cone.axes[2];
    return {point + (x * (alpha * l3) - z * (beta * l1)) / (l2 * all),
            (x * alpha + z * beta).normalized(), std::sqrt(l1 * l3 / all) / l2};
}

double entry_of(const DiscLight& light, const Vec3& origin, const Vec3& direction) {
    return light.normal.dot(light.center - origin) / light.normal.dot(direction);
}

double entry_of(const EllipsoidLight& light, const Vec3& origin, const Vec3& direction) {
    return entry_of(SphereLight{Vec3(0), 1}, light.in_sphere(origin - light.center),
                    light.in_sphere(direction));
}

} // namespace keiko
