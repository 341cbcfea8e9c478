#include "keiko/light/tubes/ray_cone.h"

#include "keiko/light/tubes/c_plane_lookup.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace keiko;

namespace {

CPlaneFrame ceiling(bool luminous_caps) {
    CPlane plane;
    plane.u = {1000, 0, 0};
    plane.v = {0, 1200, 0};
    plane.lamps = 12;
    plane.diameter = 30;
    plane.luminous_caps = luminous_caps;
    return CPlaneFrame(plane);
}

class RandomBundles {
public:
    /// Below the plane, some beyond it, mostly towards it; of very different widths, some of them
    /// nothing.
    RayCone bundle() {
        RayCone rays;
        rays.origin = Vec3(500, 600, -1000) + in_ball(2500);
        rays.direction = Vec3(0, 0, 0.5) + in_ball(1);
        const double width = std::pow(10, 4 * uniform() - 4);
        const auto share = [&](double most) {
            return uniform() < 0.5 ? 0 : most * width * uniform();
        };
        rays.spread = {in_ball(share(1000)), in_ball(share(1000)), in_ball(share(1)),
                       in_ball(share(1))};
        rays.origin_rest = share(400), rays.direction_rest = share(0.4);
        rays.origin_slope_rest = share(400), rays.direction_slope_rest = share(0.4);
        return rays;
    }
    /// Most of them as far out as may be, along an axis of space.
    Vec3 at_rim(double radius) {
        if (uniform() < 0.2) return in_ball(radius);
        Vec3 p(0);
        p[static_cast<unsigned>(3 * uniform())] = sign() * radius;
        return p;
    }
    /// Half a unit to all sides, most of them corners.
    double place() { return uniform() < 0.2 ? uniform() - 0.5 : sign() / 2; }
    double sign() { return uniform() < 0.5 ? -1 : 1; }
    Vec3 in_ball(double radius) {
        for (;;) {
            const Vec3 p(2 * uniform() - 1, 2 * uniform() - 1, 2 * uniform() - 1);
            if (p.length() <= 1) return p * radius;
        }
    }
    double uniform() { return std::uniform_real_distribution<double>(0, 1)(engine_); }

private:
    std::mt19937_64 engine_{20261122};
};

/// Coverage of a ray of the bundle and its footprint.
double coverage(const CPlaneFrame& frame, const RayCone& rays, MirrorModel look,
                RandomBundles& random) {
    const RayDifferentials& s = rays.spread;
    const double x = random.place(), y = random.place();
    const Vec3 origin =
        rays.origin + s.origin_dx * x + s.origin_dy * y + random.at_rim(rays.origin_rest);
    const Vec3 direction = rays.direction + s.direction_dx * x + s.direction_dy * y +
                           random.at_rim(rays.direction_rest);
    const RayDifferentials spread{s.origin_dx + random.at_rim(rays.origin_slope_rest),
                                  s.origin_dy + random.at_rim(rays.origin_slope_rest),
                                  s.direction_dx + random.at_rim(rays.direction_slope_rest),
                                  s.direction_dy + random.at_rim(rays.direction_slope_rest)};
    const auto hit = c_plane_coordinates(frame, origin, direction);
    if (!hit) return 0;
    return look_up(frame, *hit, origin, direction, footprint_on(frame, *hit, spread), look)
        .coverage;
}

} // namespace

TEST(RayCone, MissesLampsWhereEachOfItsRaysDoes) {
    RandomBundles random;
    int proved = 0, dark = 0;
    constexpr int bundles = 20000;
    for (int i = 0; i < bundles; ++i) {
        const CPlaneFrame frame = ceiling(i % 2 == 0);
        const RayCone rays = random.bundle();
        const bool misses = misses_lamps(frame, rays);
        bool lit = false;
        for (const MirrorModel look : {MirrorModel::flat, MirrorModel::tube, MirrorModel::exact})
            for (int k = 0; k < (look == MirrorModel::exact ? 1 : 40); ++k)
                lit = lit || coverage(frame, rays, look, random) > 0;
        EXPECT_FALSE(misses && lit) << i;
        proved += misses ? 1 : 0;
        dark += lit ? 0 : 1;
    }
    EXPECT_GT(dark - proved, 0); // bounds are bounds
    EXPECT_GT(proved, dark / 2);
    EXPECT_LT(dark, bundles);
}

// Straight up beside the first lamp of a row and between it and the next.
TEST(RayCone, IsToldFromItsNeighbourAtTheRim) {
    const CPlaneFrame frame = ceiling(false);
    const auto misses = [&](double v, double off) {
        RayCone rays;
        rays.origin = {500, v, -1000}, rays.direction = {0, 0, 1};
        rays.origin_rest = off;
        return misses_lamps(frame, rays);
    };
    for (const double side : {-1, 1}) {
        const double rim = frame.first + side * frame.radius();
        EXPECT_TRUE(misses(rim + side * 0.1, 0));
        EXPECT_FALSE(misses(rim - side * 0.1, 0));
        EXPECT_FALSE(misses(rim + side * 0.1, 1));
        EXPECT_TRUE(misses(rim + side * 10, 1));
    }
}

// So wide a footprint that the row counts as grey, and beyond its last lamp's share of it.
TEST(RayCone, OfUnresolvedLampsMissesNoneOfTheRow) {
    const CPlaneFrame frame = ceiling(false);
    const auto misses = [&](double v) {
        RayCone rays;
        rays.origin = {500, v, -1000}, rays.direction = {0, 0, 1};
        rays.spread.origin_dy = {0, 5 * frame.pitch, 0};
        return misses_lamps(frame, rays);
    };
    EXPECT_FALSE(misses(frame.axis(5) + frame.pitch / 2));
    EXPECT_FALSE(misses(frame.first - 5 * frame.pitch));
    EXPECT_TRUE(misses(frame.first - 50 * frame.pitch));
}

TEST(RayCone, ThatRunsAwayMissesAll) {
    const CPlaneFrame frame = ceiling(true);
    RayCone rays;
    rays.origin = {500, 600, 10}, rays.direction = {0.1, 0, 1};
    EXPECT_TRUE(misses_lamps(frame, rays));
    rays.origin_rest = 11; // some begin below the plane
    EXPECT_FALSE(misses_lamps(frame, rays));
    rays.origin_rest = 0, rays.direction_rest = 2; // some turn back
    EXPECT_FALSE(misses_lamps(frame, rays));
}
