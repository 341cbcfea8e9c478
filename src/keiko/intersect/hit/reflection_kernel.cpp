#include "keiko/intersect/hit/reflection_kernel.h"

#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "keiko/intersect/hit/reflection_kernel.cpp"
// First: it includes this file once for each instruction set.
#include <hwy/foreach_target.h>

// Then what is made for the one in hand.
#include "keiko/intersect/kernels/space_lanes-inl.h"

// No fused multiply-adds: reflect_ray.cpp has none, and a ray is to be the same in any company.

HWY_BEFORE_NAMESPACE();
namespace keiko::HWY_NAMESPACE {

/// Lanes of LocalSurface and the functions of reflect_ray.cpp, step by step.
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
        constexpr double singular_sine = 1e-6; // as there
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

} // namespace keiko
#endif
