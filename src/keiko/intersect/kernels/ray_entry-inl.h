// Compiled once for each instruction set by sub_patch_kernels.cpp.
#if defined(KEIKO_INTERSECT_RAY_ENTRY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KEIKO_INTERSECT_RAY_ENTRY_INL_H
#undef KEIKO_INTERSECT_RAY_ENTRY_INL_H
#else
#define KEIKO_INTERSECT_RAY_ENTRY_INL_H
#endif

#include "keiko/intersect/kernels/lanes-inl.h"

#include <algorithm>
#include <bit>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace keiko::HWY_NAMESPACE {

/// Length below which the squares of a direction leave the range of double precision.
constexpr double shortest_direction = 1e-140;
/// Length above which the squares of a direction leave that range.
constexpr double longest_direction = 1.1e150;
/// mm: the same of the way to the scene.
constexpr double farthest_origin = 1e150;

/// Dot product of the vectors of each lane, by fused multiply-adds where the target has them.
template <class V>
V dot(const std::array<V, 3>& a, const std::array<V, 3>& b) {
    return hn::MulAdd(a[2], b[2], hn::MulAdd(a[1], b[1], hn::Mul(a[0], b[0])));
}

/// The lanes of an array of vectors that begin at `lane`.
template <class D>
std::array<hn::Vec<D>, 3> load_vectors(D d, const std::array<RayPacket::Lanes<double>, 3>& from,
                                       std::size_t lane) {
    return {hn::Load(d, from[0].data() + lane), hn::Load(d, from[1].data() + lane),
            hn::Load(d, from[2].data() + lane)};
}

/// Rays as given, and how they pass the ball around the scene.
template <class D>
struct BallPass {
    using V = hn::Vec<D>; ///< One number of each ray.
    static constexpr double epsilon = std::numeric_limits<double>::epsilon(); ///< 2^-52

    std::array<V, 3> origin, given, direction; ///< `direction` of length 1
    V speed;                                   ///< mm for each unit of t
    V foot;              ///< mm from the origin to the place nearest to the centre
    V away;              ///< mm from the origin to the centre
    V ball;              ///< radius of the ball, and what may pass for it
    V half_square, half; ///< of half the chord, mm

    /// Passes of the rays of a vector that begins at `lane`. Their `start` and `direction` must
    /// still be as given.
    BallPass(D d, const SceneBall& scene, const RayPacket& rays, std::size_t lane)
        : origin(load_vectors(d, rays.start, lane)), given(load_vectors(d, rays.direction, lane)) {
        speed = hn::Sqrt(dot(given, given));
        std::array<V, 3> to_center, off;
        for (unsigned k = 0; k < 3; ++k) {
            direction[k] = hn::Div(given[k], speed);
            to_center[k] = hn::Sub(hn::Set(d, scene.center[k]), origin[k]);
        }
        foot = dot(to_center, direction);
        away = hn::Sqrt(dot(to_center, to_center));
        for (unsigned k = 0; k < 3; ++k) off[k] = hn::NegMulAdd(direction[k], foot, to_center[k]);
        // Far origins blur the ball's border: whatever may touch it must come in.
        ball = hn::MulAdd(hn::Set(d, 64 * epsilon), away, hn::Set(d, scene.radius * 1.001));
        half_square = hn::NegMulAdd(
            off[0], off[0],
            hn::NegMulAdd(off[1], off[1], hn::NegMulAdd(off[2], off[2], hn::Mul(ball, ball))));
        half = hn::Sqrt(half_square);
    }

    /// Lanes whose rays start in the ball.
    auto inside() const { return hn::Le(away, ball); }
    /// Parameter of the start within the ball. It does not depend on t_min: a hit's t must have the
    /// same last bit for any range of the query.
    V t_start() const { return hn::IfThenZeroElse(inside(), hn::Div(hn::Sub(foot, half), speed)); }
    /// mm: rounding between distances and t.
    V slack(D d) const { return hn::Mul(hn::Set(d, 8 * epsilon), hn::Add(away, ball)); }
    /// Error of a start moved by `way` mm, in mm. One that is not moved is not rounded.
    V error(D d, V way) const {
        const V moved =
            hn::Mul(hn::Set(d, 2 * epsilon), hn::Add(hn::Sqrt(dot(origin, origin)), hn::Abs(way)));
        return hn::IfThenZeroElse(inside(), moved);
    }
    /// Has a direction, comes from not too far, and meets the ball.
    auto enters(D d) const {
        return hn::And(
            hn::And(hn::Gt(speed, hn::Set(d, shortest_direction)),
                    hn::Lt(speed, hn::Set(d, longest_direction))),
            hn::And(hn::Lt(away, hn::Set(d, farthest_origin)), hn::Ge(half_square, hn::Zero(d))));
    }
};

/// The start moved up to the ball; no lane of the result that has no direction, or misses it.
template <class D>
LaneMask enter_lanes(D d, const SceneBall& scene, RayPacket& rays, std::size_t lane) {
    using V = hn::Vec<D>;
    const BallPass<D> pass(d, scene, rays, lane);
    const auto store = [&](V value, RayPacket::Lanes<double>& to) {
        hn::Store(value, d, to.data() + lane);
    };
    const V t_start = pass.t_start();
    const V way = hn::Mul(t_start, pass.speed), slack = pass.slack(d), error = pass.error(d, way);
    for (unsigned k = 0; k < 3; ++k) {
        store(hn::MulAdd(pass.given[k], t_start, pass.origin[k]), rays.start[k]);
        store(pass.direction[k], rays.direction[k]);
    }
    const V t_low = hn::Mul(hn::Load(d, rays.low.data() + lane), pass.speed);
    const V t_high = hn::Mul(hn::Load(d, rays.high.data() + lane), pass.speed);
    const V begin = hn::Sub(pass.foot, pass.half), end = hn::Add(pass.foot, pass.half);
    const V low = hn::Sub(hn::Sub(hn::Max(t_low, begin), way), slack);
    const V high = hn::Add(hn::Sub(hn::Min(t_high, end), way), slack);
    store(low, rays.low);
    store(high, rays.high);
    store(t_start, rays.t_start);
    store(pass.speed, rays.speed);
    store(error, rays.error);
    store(slack, rays.slack);
    // No sub-patch's frame is centred farther away than across the ball.
    store(hn::Add(error, hn::Set(d, ray_rounding * 2.5 * scene.radius)), rays.blur);
    // What the boxes are padded by has so much room for a blurred start: see pad_in_radii.
    const V most_error = hn::Set(d, 0x1p-22 * std::max(scene.radius, 1e-30));
    const auto ranges = hn::And(hn::Le(t_low, t_high), hn::Le(low, high));
    return lane_bits(d, hn::And(hn::And(pass.enters(d), ranges), hn::Le(error, most_error)), lane);
}

/// Whether all active rays are close to the first, in direction and in where they start.
bool are_coherent(const SceneBall& scene, const RayPacket& rays) {
    constexpr double widest_turn = 0.1, widest_spread = 0.1;
    const Wide d;
    const auto first = static_cast<std::size_t>(std::countr_zero(rays.active));
    const auto limit = [&](double x) { return hn::Set(d, x * x); };
    for (std::size_t lane = 0; lane < rays.count; lane += hn::Lanes(d)) {
        const auto apart = [&](const std::array<RayPacket::Lanes<double>, 3>& a) {
            auto sum = hn::Zero(d);
            for (unsigned k = 0; k < 3; ++k) {
                const auto off = hn::Sub(hn::Load(d, a[k].data() + lane), hn::Set(d, a[k][first]));
                sum = hn::MulAdd(off, off, sum);
            }
            return sum;
        };
        const auto close = hn::And(hn::Lt(apart(rays.direction), limit(widest_turn)),
                                   hn::Lt(apart(rays.start), limit(widest_spread * scene.radius)));
        const LaneMask here = ((LaneMask{1} << hn::Lanes(d)) - 1) << lane;
        if ((rays.active & here & ~lane_bits(d, close, lane)) != 0) return false;
    }
    return true;
}

/// Makes traced rays of the rays of a packet; see SubPatchKernels::enter.
void enter(const SceneBall& scene, RayPacket& rays) {
    for (std::size_t lane = 0; lane < rays.count; ++lane) {
        const Ray& ray = *rays.rays[lane];
        for (unsigned k = 0; k < 3; ++k) {
            rays.start[k][lane] = ray.origin[k];
            rays.direction[k][lane] = ray.direction[k];
        }
        rays.low[lane] = ray.t_min;
        rays.high[lane] = ray.t_max;
    }
    rays.coherent = false;
    if (rays.count == 1) {
        rays.active = enter_lanes(One(), scene, rays, 0);
        return;
    }
    const auto used = static_cast<LaneMask>((std::uint64_t{1} << rays.count) - 1);
    rays.active = 0;
    for_vectors(used,
                [&](std::size_t lane) { rays.active |= enter_lanes(Wide(), scene, rays, lane); });
    rays.active &= used;
    rays.coherent = rays.active != 0 && are_coherent(scene, rays);
}

} // namespace keiko::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
