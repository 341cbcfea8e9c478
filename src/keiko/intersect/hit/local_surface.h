#pragma once

#include "keiko/intersect/hit/hit.h"

#include <algorithm>

namespace keiko {

/// The surface at a hit to second order: how its unit normal changes along a tangent. For hits with
/// second derivatives where is_regular() holds.
class LocalSurface {
public:
    /// The normal of the hit may have been turned to the other side.
    explicit LocalSurface(const Hit& hit)
        : normal_(hit.normal), su_(hit.dpdu), sv_(hit.dpdv), area_(su_.cross(sv_)) {
        const Vec3 nu = hit.second->duu.cross(sv_) + su_.cross(hit.second->duv);
        const Vec3 nv = hit.second->duv.cross(sv_) + su_.cross(hit.second->dvv);
        const double scale = (area_.dot(normal_) < 0 ? -1 : 1) / area_.length();
        normal_du_ = (nu - normal_ * normal_.dot(nu)) * scale;
        normal_dv_ = (nv - normal_ * normal_.dot(nv)) * scale;
    }

    /// Change of the unit normal along the tangent vector `step`.
    Vec3 normal_change(const Vec3& step) const {
        // By areas: the determinant of the first form cancels where the tangents are all but
        // parallel.
        const double u = step.cross(sv_).dot(area_), v = su_.cross(step).dot(area_);
        return (normal_du_ * u + normal_dv_ * v) / area_.dot(area_);
    }

private:
    Vec3 normal_, su_, sv_;
    Vec3 area_; ///< su x sv
    Vec3 normal_du_{0}, normal_dv_{0};
};

/// Change of the hit point when the ray changes by (origin_d, direction_d), in the tangent plane
/// [Igehy1999].
inline Vec3 transfer(const Ray& ray, const Hit& hit, const Vec3& origin_d,
                     const Vec3& direction_d) {
    const Vec3 moved = origin_d + direction_d * hit.t;
    return moved - ray.direction * (moved.dot(hit.normal) / ray.direction.dot(hit.normal));
}

/// At a pole the tangents say nothing about how the normal changes. Of tangents that enclose an
/// angle of sine s, the second derivatives' rounding leaves it right to some 1e-15 / s^2.
inline bool is_regular(const Hit& hit) {
    constexpr double singular_sine = 1e-6;
    return hit.dpdu.cross(hit.dpdv).length() >
           singular_sine * hit.dpdu.length() * hit.dpdv.length();
}

/// Distance in patch parameters, to first order, to where the tangents enclose no area: 0 at a
/// pole, infinite on planes. Requires second derivatives. Their rounding leaves the change of the
/// normal right to some 1e-16 over the square of it.
inline double distance_to_pole(const Hit& hit) {
    const SecondDerivatives& second = *hit.second;
    const Vec3 by_u = second.duu.cross(hit.dpdv) + hit.dpdu.cross(second.duv);
    const Vec3 by_v = second.duv.cross(hit.dpdv) + hit.dpdu.cross(second.dvv);
    return hit.dpdu.cross(hit.dpdv).length() / std::max(by_u.length(), by_v.length());
}

} // namespace keiko
