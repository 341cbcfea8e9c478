#include "keiko/placement/mirrored_ray.h"

namespace keiko {
namespace {

/// sin(du, dv) below which a patch counts as not regular.
constexpr double singular = 1e-9;

/// Derivative of the unit normal along a tangent `step` of a regular patch.
Vec3 normal_change(const SurfaceDerivatives& s, const Vec3& step) {
    const Vec3 cross = s.du().cross(s.dv());
    const double area2 = cross.length2();
    const double u = step.cross(s.dv()).dot(cross) / area2;
    const double v = s.du().cross(step).dot(cross) / area2;
    const Vec3 change =
        (s.duu() * u + s.duv() * v).cross(s.dv()) + s.du().cross(s.duv() * u + s.dvv() * v);
    const Vec3 normal = cross / std::sqrt(area2);
    return (change - normal * normal.dot(change)) / std::sqrt(area2);
}

/// How a ray changes with one coordinate of the picture.
struct Change {
    Vec3 origin, direction;
};

/// Igehy 1999, Tracing ray differentials, sections 3.1.1 and 3.1.2.
Change mirrored(const SurfaceDerivatives& s, const Vec3& normal, const Ray& ray, double t,
                const Change& change) {
    const Vec3& d = ray.direction;
    const Vec3 drift = change.origin + change.direction * t;
    const Vec3 position = drift - d * (normal.dot(drift) / normal.dot(d));
    const double side = normal.dot(s.du().cross(s.dv())) > 0 ? 1 : -1;
    const Vec3 turn = normal_change(s, position) * side;
    const double slope = change.direction.dot(normal) + d.dot(turn);
    return {position, change.direction - (normal * slope + turn * d.dot(normal)) * 2};
}

} // namespace

SurfaceDerivatives world_derivatives(const SurfaceModel& model, const Hit& hit) {
    SurfaceDerivatives s = evaluate(model.patch(hit.patch), hit.uv, 2);
    const Affine& placed = model.instances[hit.instance].transform;
    for (std::size_t k = 0; k <= 2; ++k)
        for (std::size_t l = 0; k + l <= 2; ++l) s.d[k][l] = placed.vector(s.d[k][l]);
    s.d[0][0] += placed.translation;
    return s;
}

Vec3 facing_normal(const Hit& hit, const Ray& ray) {
    return hit.normal.dot(ray.direction) > 0 ? -hit.normal : hit.normal;
}

Ray mirrored_ray(const SurfaceModel& model, const Hit& hit, const Ray& eye_ray) {
    const Vec3 normal = facing_normal(hit, eye_ray);
    Ray mirror{.origin = hit.position,
               .direction = reflect(eye_ray.direction, normal),
               .differentials = {},
               .excluded = hit.root};
    if (!eye_ray.differentials) return mirror;

    const SurfaceDerivatives s = world_derivatives(model, hit);
    const double sine = s.du().cross(s.dv()).length();
    if (!(sine > singular * s.du().length() * s.dv().length())) return mirror;
    if (!(normal.dot(eye_ray.direction) < 0)) return mirror;
    const RayDifferentials& eye = *eye_ray.differentials;
    const Change dx = mirrored(s, normal, eye_ray, hit.t, {eye.origin_dx, eye.direction_dx});
    const Change dy = mirrored(s, normal, eye_ray, hit.t, {eye.origin_dy, eye.direction_dy});
    mirror.differentials = {dx.origin, dy.origin, dx.direction, dy.direction};
    return mirror;
}

} // namespace keiko
