#include "keiko/placement/mirrored_ray.h"

#include "keiko/intersect/hit/reflect_ray.h"

namespace keiko {

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

Ray mirrored_ray(const SurfaceModel& model, const Hit& hit, const Ray& camera_ray) {
    if (hit.second) return reflect_ray(camera_ray, hit);
    const SurfaceDerivatives s = world_derivatives(model, hit);
    Hit whole = hit;
    whole.second = {s.duu(), s.duv(), s.dvv()};
    return reflect_ray(camera_ray, whole);
}

} // namespace keiko
