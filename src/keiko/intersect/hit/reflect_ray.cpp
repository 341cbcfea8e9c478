#include "keiko/intersect/hit/reflect_ray.h"

namespace keiko {

namespace {

/// The surface at a hit to second order: how position and unit normal change along a tangent.
class LocalSurface {
public:
    explicit LocalSurface(const Hit& hit)
        : normal_(hit.normal), su_(hit.dpdu), sv_(hit.dpdv), area_(su_.cross(sv_)) {
        const Vec3 nu = hit.second->duu.cross(sv_) + su_.cross(hit.second->duv);
        const Vec3 nv = hit.second->duv.cross(sv_) + su_.cross(hit.second->dvv);
        // The caller may have turned the normal to the other side.
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

/// Change of the hit point when the ray changes by (origin_d, direction_d), in the tangent plane.
Vec3 transfer(const Ray& ray, const Hit& hit, const Vec3& origin_d, const Vec3& direction_d) {
    const Vec3 moved = origin_d + direction_d * hit.t;
    return moved - ray.direction * (moved.dot(hit.normal) / ray.direction.dot(hit.normal));
}

Vec3 reflect_change(const Vec3& d, const Vec3& n, const Vec3& d_change, const Vec3& n_change) {
    return d_change - (n_change * d.dot(n) + n * (d_change.dot(n) + d.dot(n_change))) * 2;
}

/// At a pole the tangents say nothing about how the normal changes. Of tangents that enclose an
/// angle of sine s, the second derivatives' rounding leaves it right to some 1e-15 / s^2.
bool regular(const Hit& hit) {
    constexpr double singular_sine = 1e-6;
    return hit.dpdu.cross(hit.dpdv).length() >
           singular_sine * hit.dpdu.length() * hit.dpdv.length();
}

} // namespace

Ray reflect_ray(const Ray& incoming, const Hit& hit) {
    Ray mirrored;
    reflect_ray(incoming, hit, mirrored);
    return mirrored;
}

void reflect_ray(const Ray& incoming, const Hit& hit, Ray& mirrored) {
    mirrored.origin = hit.position;
    mirrored.direction = reflect(incoming.direction, hit.normal);
    mirrored.excluded = hit.root;
    if (!incoming.differentials || !hit.second || !regular(hit)) return;

    const RayDifferentials& in = *incoming.differentials;
    const LocalSurface surface(hit);
    RayDifferentials& out = mirrored.differentials.emplace();
    out.origin_dx = transfer(incoming, hit, in.origin_dx, in.direction_dx);
    out.origin_dy = transfer(incoming, hit, in.origin_dy, in.direction_dy);
    out.direction_dx = reflect_change(incoming.direction, hit.normal, in.direction_dx,
                                      surface.normal_change(out.origin_dx));
    out.direction_dy = reflect_change(incoming.direction, hit.normal, in.direction_dy,
                                      surface.normal_change(out.origin_dy));
    // At an exact silhouette the first order says nothing.
    if (!(is_finite(out.origin_dx) && is_finite(out.origin_dy) && is_finite(out.direction_dx) &&
          is_finite(out.direction_dy)))
        mirrored.differentials.reset();
}

namespace {

void put(MirrorBlock::Vectors& to, std::size_t lane, const Vec3& v) {
    to[0][lane] = v.x, to[1][lane] = v.y, to[2][lane] = v.z;
}

Vec3 at(const MirrorBlock::Vectors& from, std::size_t lane) {
    return {from[0][lane], from[1][lane], from[2][lane]};
}

} // namespace

void ReflectionBatch::add(const Ray& incoming, const Hit& hit, Ray& mirrored) {
    if (!incoming.differentials || !hit.second) return reflect_ray(incoming, hit, mirrored);
    asked_[block_.count] = {&incoming, &hit, &mirrored};
    ask(block_.count++);
    if (block_.count == MirrorBlock::capacity) finish();
}

void ReflectionBatch::finish() {
    if (block_.count == 0) return;
    kernel_(block_);
    for (std::size_t lane = 0; lane < block_.count; ++lane) write(lane);
    block_.count = 0;
}

void ReflectionBatch::ask(std::size_t lane) {
    const auto& [incoming, hit, mirrored] = asked_[lane];
    const RayDifferentials& d = *incoming->differentials;
    put(block_.direction, lane, incoming->direction);
    put(block_.incoming.origin_dx, lane, d.origin_dx);
    put(block_.incoming.origin_dy, lane, d.origin_dy);
    put(block_.incoming.direction_dx, lane, d.direction_dx);
    put(block_.incoming.direction_dy, lane, d.direction_dy);
    block_.t[lane] = hit->t;
    put(block_.normal, lane, hit->normal);
    put(block_.du, lane, hit->dpdu), put(block_.dv, lane, hit->dpdv);
    put(block_.duu, lane, hit->second->duu);
    put(block_.duv, lane, hit->second->duv);
    put(block_.dvv, lane, hit->second->dvv);
}

void ReflectionBatch::write(std::size_t lane) const {
    const auto& [incoming, hit, mirrored] = asked_[lane];
    if ((block_.plain >> lane & 1) == 0) return reflect_ray(*incoming, *hit, *mirrored);
    mirrored->origin = hit->position;
    mirrored->direction = at(block_.mirrored_direction, lane);
    mirrored->excluded = hit->root;
    const MirrorBlock::Differentials& from = block_.mirrored;
    RayDifferentials& d = mirrored->differentials.emplace();
    d.origin_dx = at(from.origin_dx, lane), d.origin_dy = at(from.origin_dy, lane);
    d.direction_dx = at(from.direction_dx, lane), d.direction_dy = at(from.direction_dy, lane);
}

} // namespace keiko
