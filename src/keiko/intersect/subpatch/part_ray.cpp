#include "keiko/intersect/subpatch/part_ray.h"

#include <cmath>
#include <limits>

namespace keiko {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Vector from the sub-patch's centre to the place of the ray nearest to it. Starting from there
/// keeps the numbers as small as the sub-patch, however far off the ray begins.
Vec3 foot_point(const PartRay& ray, const SubPatch& sub_patch, double& foot) {
    const Vec3 to_center = sub_patch.center - ray.origin;
    foot = to_center.dot(ray.direction);
    return ray.direction * foot - to_center;
}

} // namespace

PartRay part_ray(const Vec3& origin, const Vec3& direction, double error) {
    PartRay ray;
    ray.origin = origin;
    ray.speed = direction.length();
    ray.direction = direction / ray.speed;
    // Two normals across the direction [Duff2017].
    const Vec3& d = ray.direction;
    const double sign = std::copysign(1.0, d.z), a = -1 / (sign + d.z), b = d.x * d.y * a;
    ray.normal_f = {1 + sign * d.x * d.x * a, sign * b, -sign * d.x};
    ray.normal_g = {b, sign + d.y * d.y * a, -d.y};
    ray.error = error;
    return ray;
}

bool near_sub_patch(const PartRay& ray, const SubPatch& sub_patch) {
    double foot = 0;
    const Vec3 off = foot_point(ray, sub_patch, foot);
    const double reach =
        sub_patch.radius + sub_patch.coefficient_error + ray.error + ray.turn * std::abs(foot);
    // The 1 + 1e-9 covers the rounding of the three lines above.
    return off.dot(off) <= reach * reach * (1 + 1e-9) + 1e-30 * foot * foot;
}

RayProjection project_ray(const PartRay& ray, const SubPatch& sub_patch,
                          const BezierPatchView& points) {
    RayProjection view;
    const Vec3 off = foot_point(ray, sub_patch, view.foot);
    const double off_f = ray.normal_f.dot(off), off_g = ray.normal_g.dot(off);
    view.net.degree_u = points.degree_u;
    view.net.degree_v = points.degree_v;
    for (std::size_t i = 0; i < points.points.size(); ++i) {
        const Vec4& p = points.points[i];
        const Vec3 xyz(p.x, p.y, p.z);
        view.net.f[i] = ray.normal_f.dot(xyz) - p.w * off_f;
        view.net.g[i] = ray.normal_g.dot(xyz) - p.w * off_g;
    }
    const double size = sub_patch.radius + off.length();
    const double steps = 8 + 4.0 * (points.degree_u + points.degree_v);
    view.slack = sub_patch.weight *
                 (epsilon * steps * size + (4 * epsilon + ray.turn) * std::abs(view.foot) +
                  sub_patch.coefficient_error + ray.error);
    return view;
}

} // namespace keiko
