#include "keiko/trace/mirror_ray.h"

namespace keiko {
namespace {

/// The surface at a hit to second order: how position and unit normal change along a tangent.
class LocalSurface {
public:
    explicit LocalSurface(const Hit& hit)
        : normal_(hit.normal),
          su_(hit.dpdu),
          sv_(hit.dpdv),
          e_(su_.dot(su_)),
          f_(su_.dot(sv_)),
          g_(sv_.dot(sv_)) {
        const Vec3 nu = hit.second->duu.cross(sv_) + su_.cross(hit.second->duv);
        const Vec3 nv = hit.second->duv.cross(sv_) + su_.cross(hit.second->dvv);
        const Vec3 n = su_.cross(sv_);
        // `normal` may be the reverse of su x sv on mirrored instances.
        const double scale = (n.dot(normal_) < 0 ? -1 : 1) / n.length();
        normal_du_ = (nu - normal_ * normal_.dot(nu)) * scale;
        normal_dv_ = (nv - normal_ * normal_.dot(nv)) * scale;
    }

    /// Change of the unit normal along the tangent vector `step`.
    Vec3 normal_change(const Vec3& step) const {
        const double a = step.dot(su_), b = step.dot(sv_), determinant = e_ * g_ - f_ * f_;
        return (normal_du_ * (g_ * a - f_ * b) + normal_dv_ * (e_ * b - f_ * a)) / determinant;
    }

private:
    Vec3 normal_, su_, sv_, normal_du_{0}, normal_dv_{0};
    double e_, f_, g_;
};

/// Change of the hit point when the ray changes by (origin_d, direction_d), in the tangent plane.
Vec3 transfer(const Ray& ray, const Hit& hit, const Vec3& origin_d, const Vec3& direction_d) {
    const Vec3 moved = origin_d + direction_d * hit.t;
    return moved - ray.direction * (moved.dot(hit.normal) / ray.direction.dot(hit.normal));
}

Vec3 reflect_change(const Vec3& d, const Vec3& n, const Vec3& d_change, const Vec3& n_change) {
    return d_change - (n_change * d.dot(n) + n * (d_change.dot(n) + d.dot(n_change))) * 2;
}

/// At a pole the tangents say nothing about how the normal changes.
bool regular(const Hit& hit) {
    constexpr double singular_sine = 1e-9;
    return hit.dpdu.cross(hit.dpdv).length() >
           singular_sine * hit.dpdu.length() * hit.dpdv.length();
}

} // namespace

Ray mirror_ray(const Ray& incoming, const Hit& hit) {
    Ray mirrored;
    mirrored.origin = hit.position;
    mirrored.direction = reflect(incoming.direction, hit.normal);
    mirrored.excluded = hit.root;
    if (!incoming.differentials || !hit.second || !regular(hit)) return mirrored;

    const RayDifferentials& in = *incoming.differentials;
    const LocalSurface surface(hit);
    RayDifferentials out;
    out.origin_dx = transfer(incoming, hit, in.origin_dx, in.direction_dx);
    out.origin_dy = transfer(incoming, hit, in.origin_dy, in.direction_dy);
    out.direction_dx = reflect_change(incoming.direction, hit.normal, in.direction_dx,
                                      surface.normal_change(out.origin_dx));
    out.direction_dy = reflect_change(incoming.direction, hit.normal, in.direction_dy,
                                      surface.normal_change(out.origin_dy));
    // At an exact silhouette the first order says nothing.
    if (is_finite(out.origin_dx) && is_finite(out.origin_dy) && is_finite(out.direction_dx) &&
        is_finite(out.direction_dy))
        mirrored.differentials = out;
    return mirrored;
}

} // namespace keiko
