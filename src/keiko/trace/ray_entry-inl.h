// Compiled once for each instruction set by leaf_kernels.cpp.
#if defined(KEIKO_TRACE_RAY_ENTRY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KEIKO_TRACE_RAY_ENTRY_INL_H
#undef KEIKO_TRACE_RAY_ENTRY_INL_H
#else
#define KEIKO_TRACE_RAY_ENTRY_INL_H
#endif

#include "keiko/trace/lanes-inl.h"
#include "keiko/trace/ray_blur.h"

#include <algorithm>
#include <bit>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace keiko::HWY_NAMESPACE {

/// Beyond these the squares of a direction leave the range of double precision.
constexpr double shortest_direction = 1e-140, longest_direction = 1.1e150;
/// mm: the same of the way to the scene.
constexpr double farthest_origin = 1e150;

/// The start moved up to the ball; no lane of the result that has no direction, or misses it.
template <class D>
LaneMask enter_lanes(D d, const SceneBall& scene, RayBlock& rays, std::size_t lane) {
    using V = hn::Vec<D>;
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    const auto load = [&](const RayBlock::Lanes<double>& from) {
        return hn::Load(d, from.data() + lane);
    };
    const auto store = [&](V value, RayBlock::Lanes<double>& to) {
        hn::Store(value, d, to.data() + lane);
    };
    const auto set = [&](double x) { return hn::Set(d, x); };
    const auto dot = [&](const std::array<V, 3>& a, const std::array<V, 3>& b) {
        return hn::MulAdd(a[2], b[2], hn::MulAdd(a[1], b[1], hn::Mul(a[0], b[0])));
    };
    const std::array<V, 3> origin{load(rays.start[0]), load(rays.start[1]), load(rays.start[2])};
    const std::array<V, 3> given{load(rays.direction[0]), load(rays.direction[1]),
                                 load(rays.direction[2])};
    const V speed = hn::Sqrt(dot(given, given));
    std::array<V, 3> direction, to_center, off;
    for (unsigned k = 0; k < 3; ++k) {
        direction[k] = hn::Div(given[k], speed);
        to_center[k] = hn::Sub(set(scene.center[k]), origin[k]);
    }
    const V foot = dot(to_center, direction), away = hn::Sqrt(dot(to_center, to_center));
    for (unsigned k = 0; k < 3; ++k) off[k] = hn::NegMulAdd(direction[k], foot, to_center[k]);
    // Far origins blur the ball's border: whatever may touch it must come in.
    const V ball = hn::MulAdd(set(64 * epsilon), away, set(scene.radius * 1.001));
    const V half_square = hn::NegMulAdd(
        off[0], off[0],
        hn::NegMulAdd(off[1], off[1], hn::NegMulAdd(off[2], off[2], hn::Mul(ball, ball))));
    const V half = hn::Sqrt(half_square);
    // Not t_min: a hit's t must have the same last bit whatever range it is asked in.
    const auto inside = hn::Le(away, ball);
    const V t_start = hn::IfThenZeroElse(inside, hn::Div(hn::Sub(foot, half), speed));
    for (unsigned k = 0; k < 3; ++k) {
        store(hn::MulAdd(given[k], t_start, origin[k]), rays.start[k]);
        store(direction[k], rays.direction[k]);
    }
    const V way = hn::Mul(t_start, speed);
    const V slack = hn::Mul(set(8 * epsilon), hn::Add(away, ball));
    const V ball_size = set(std::max(scene.radius, 1e-30));
    // A start that is not moved is not rounded.
    const V moved = hn::Mul(set(2 * epsilon), hn::Add(hn::Sqrt(dot(origin, origin)), hn::Abs(way)));
    const V error = hn::IfThenZeroElse(inside, moved);
    const V t_low = hn::Mul(load(rays.low), speed), t_high = hn::Mul(load(rays.high), speed);
    const V low = hn::Sub(hn::Sub(hn::Max(t_low, hn::Sub(foot, half)), way), slack);
    const V high = hn::Add(hn::Sub(hn::Min(t_high, hn::Add(foot, half)), way), slack);
    store(low, rays.low);
    store(high, rays.high);
    store(t_start, rays.t_start);
    store(speed, rays.speed);
    store(error, rays.error);
    store(slack, rays.slack);
    // No leaf's frame is centred farther away than across the ball.
    store(hn::Add(error, set(ray_rounding * 2.5 * scene.radius)), rays.blur);
    const auto and_all = [](auto first, auto... rest) {
        ((first = hn::And(first, rest)), ...);
        return first;
    };
    // What the boxes are padded by has so much room for a blurred start: see pad_in_radii.
    const V most_error = hn::Mul(set(0x1p-22), ball_size);
    return lane_bits(
        d,
        and_all(hn::Gt(speed, set(shortest_direction)), hn::Lt(speed, set(longest_direction)),
                hn::Lt(away, set(farthest_origin)), hn::Le(error, most_error),
                hn::Ge(half_square, hn::Zero(d)), hn::Le(t_low, t_high), hn::Le(low, high)),
        lane);
}

/// Whether all active rays are close to the first, in direction and in where they start.
bool are_coherent(const SceneBall& scene, const RayBlock& rays) {
    constexpr double widest_turn = 0.1, widest_spread = 0.1;
    const Wide d;
    const auto first = static_cast<std::size_t>(std::countr_zero(rays.active));
    const auto limit = [&](double x) { return hn::Set(d, x * x); };
    for (std::size_t lane = 0; lane < rays.count; lane += hn::Lanes(d)) {
        const auto apart = [&](const std::array<RayBlock::Lanes<double>, 3>& a) {
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

void enter(const SceneBall& scene, RayBlock& rays) {
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
