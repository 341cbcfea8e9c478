#include "keiko/intersect/hit/reflect_ray.h"

#include "keiko/intersect/hit/local_surface.h"

#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "keiko/intersect/hit/reflect_ray.cpp"
// First: it includes this file once for each instruction set.
#include <hwy/foreach_target.h>

// Then what is made for the one in hand.
#include "keiko/intersect/kernels/lanes-inl.h"

// No fused multiply-adds: reflect_ray() has none, and a ray is to be the same in any company.

HWY_BEFORE_NAMESPACE();
namespace keiko::HWY_NAMESPACE {

/// Lanes of LocalSurface and the functions below, step by step.
class MirrorLanes {
    using D = Wide;
    using V = hn::Vec<D>;

public:
    MirrorLanes(const MirrorBlock& block, std::size_t lane)
        : direction_(load(d_, block.direction, lane)),
          normal_(load(d_, block.normal, lane)),
          su_(load(d_, block.du, lane)),
          sv_(load(d_, block.dv, lane)),
          area_(cross(su_, sv_)),
          t_(hn::Load(d_, block.t.data() + lane)),
          area2_(square(area_)),
          along_normal_(product(direction_, normal_)) {
        const Space<V> duu = load(d_, block.duu, lane), duv = load(d_, block.duv, lane);
        const Space<V> dvv = load(d_, block.dvv, lane);
        const Space<V> nu = sum(cross(duu, sv_), cross(su_, duv));
        const Space<V> nv = sum(cross(duv, sv_), cross(su_, dvv));
        const auto turned = hn::Lt(product(area_, normal_), hn::Zero(d_));
        const V side = hn::IfThenElse(turned, number(-1), number(1));
        const V scale = hn::Div(side, hn::Sqrt(area2_));
        normal_du_ = scaled(difference(nu, scaled(normal_, product(normal_, nu))), scale);
        normal_dv_ = scaled(difference(nv, scaled(normal_, product(normal_, nv))), scale);
    }

    /// Lanes beyond a pole, where no length is so short that it is found in another way.
    hn::Mask<D> regular() const {
        constexpr double singular_sine = 1e-6; // as in is_regular()
        const V shortest = number(2 * std::numeric_limits<double>::min());
        const V u2 = square(su_), v2 = square(sv_);
        const auto long_enough = hn::Ge(hn::Min(area2_, hn::Min(u2, v2)), shortest);
        const V least = hn::Mul(hn::Mul(number(singular_sine), hn::Sqrt(u2)), hn::Sqrt(v2));
        return hn::And(long_enough, hn::Gt(hn::Sqrt(area2_), least));
    }

    Space<V> mirrored_direction() const {
        return difference(direction_, scaled(normal_, hn::Mul(number(2), along_normal_)));
    }

    Space<V> transfer(const Space<V>& origin_d, const Space<V>& direction_d) const {
        const Space<V> moved = sum(origin_d, scaled(direction_d, t_));
        const V share = hn::Div(product(moved, normal_), along_normal_);
        return difference(moved, scaled(direction_, share));
    }

    /// `step`: of the origin.
    Space<V> reflect_change(const Space<V>& direction_d, const Space<V>& step) const {
        const Space<V> turn = normal_change(step);
        const V by_normal = hn::Add(product(direction_d, normal_), product(direction_, turn));
        const Space<V> change = sum(scaled(turn, along_normal_), scaled(normal_, by_normal));
        return difference(direction_d, scaled(change, number(2)));
    }

private:
    static V number(double x) { return hn::Set(d_, x); }

    Space<V> normal_change(const Space<V>& step) const {
        const V u = product(cross(step, sv_), area_), v = product(cross(su_, step), area_);
        return divided(sum(scaled(normal_du_, u), scaled(normal_dv_, v)), area2_);
    }

    static constexpr D d_{};
    Space<V> direction_, normal_, su_, sv_, area_, normal_du_, normal_dv_;
    V t_, area2_, along_normal_;
};

hn::Mask<Wide> are_finite(const Space<hn::Vec<Wide>>& a) {
    return hn::And(hn::And(hn::IsFinite(a[0]), hn::IsFinite(a[1])), hn::IsFinite(a[2]));
}

void mirror_vector(MirrorBlock& block, std::size_t lane) {
    const Wide d;
    const MirrorLanes mirror(block, lane);
    store(d, mirror.mirrored_direction(), block.mirrored_direction, lane);
    auto plain = mirror.regular();
    const auto differentiate =
        [&](const MirrorBlock::Vectors& origin_d, const MirrorBlock::Vectors& direction_d,
            MirrorBlock::Vectors& origin_to, MirrorBlock::Vectors& direction_to) {
            const auto direction_change = load(d, direction_d, lane);
            const auto origin = mirror.transfer(load(d, origin_d, lane), direction_change);
            const auto direction = mirror.reflect_change(direction_change, origin);
            plain = hn::And(plain, hn::And(are_finite(origin), are_finite(direction)));
            store(d, origin, origin_to, lane);
            store(d, direction, direction_to, lane);
        };
    const MirrorBlock::Differentials& in = block.incoming;
    MirrorBlock::Differentials& out = block.mirrored;
    differentiate(in.origin_dx, in.direction_dx, out.origin_dx, out.direction_dx);
    differentiate(in.origin_dy, in.direction_dy, out.origin_dy, out.direction_dy);
    block.plain |= lane_bits(d, plain, lane);
}

void mirror(MirrorBlock& block) {
    block.plain = 0;
    for (std::size_t lane = 0; lane < block.count; lane += hn::Lanes(Wide()))
        mirror_vector(block, lane);
}

ReflectionKernel kernel() {
    return mirror;
}

} // namespace keiko::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace keiko {

HWY_EXPORT(kernel);

ReflectionKernel reflection_kernel() {
    return HWY_DYNAMIC_DISPATCH(kernel)();
}

namespace {

/// Change of the reflected direction.
Vec3 reflect_change(const Vec3& d, const Vec3& n, const Vec3& d_change, const Vec3& n_change) {
    return d_change - (n_change * d.dot(n) + n * (d_change.dot(n) + d.dot(n_change))) * 2;
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
    if (!incoming.differentials || !hit.second || !is_regular(hit)) return;

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
#endif
