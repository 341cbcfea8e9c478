#include "keiko/render/caustics/caustics.h"

#include "keiko/light/luminance/fresnel.h"
#include "keiko/light/luminance/photometry.h"
#include "keiko/math/refract.h"
#include "keiko/render/shading/picture.h"

#include "tests/support/random.h"
#include "tests/unit/render/caustic_stages.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

// Light that mirrors and glass throw on a floor, against closed forms, and against photons counted
// one by one.

namespace keiko {
namespace {

using namespace test;
using std::numbers::pi;

constexpr double radius = 100, wall = 300;
const double elevation = 50 * pi / 180;

/// Half of a tube about the z axis, x > 0, on a floor, under a sun along x.
CausticStage half_mirror() {
    const std::vector<test::PatchData> quarters = test::cylinder(radius, wall);
    test::ShapeBuilder builder;
    builder.face({quarters[0]}).face({quarters[3]});
    builder.face({test::rectangle(-400, 400, -400, 400, 0)});
    CausticStage stage(builder.model(), perfect_mirror());
    stage.rig.sources = {
        Sun{.direction = {std::cos(elevation), 0, -std::sin(elevation)}, .illuminance = Rgb(lux)}};
    return stage;
}

/// Illuminance by one reflection in the half mirror, and how near a fold is, 0 to 1. The mirror at
/// the azimuth phi throws light along r a way s; E = E0 sin(elevation) R cos(phi) / |R cos(phi) - 2
/// s|.
struct Lit {
    double lux = 0, off_fold = 1;
};
Lit in_half_mirror(const Vec3& p) {
    const auto miss = [&](double phi) {
        const Vec2 from(radius * std::cos(phi), radius * std::sin(phi));
        return (Vec2(p.x, p.y) - from).cross(Vec2(-std::cos(2 * phi), -std::sin(2 * phi)));
    };
    Lit lit;
    constexpr int steps = 20000;
    for (int i = 0; i < steps; ++i) {
        double low = (i / static_cast<double>(steps) - 0.5) * pi, high = low + pi / steps;
        if ((miss(low) < 0) == (miss(high) < 0)) continue;
        const bool rises = miss(low) < 0;
        for (int k = 0; k < 60; ++k) {
            const double middle = (low + high) / 2;
            ((miss(middle) < 0) == rises ? low : high) = middle;
        }
        const double c = std::cos(low);
        const Vec2 from(radius * c, radius * std::sin(low));
        const Vec2 along(-std::cos(2 * low), -std::sin(2 * low));
        const double s = (Vec2(p.x, p.y) - from).dot(along);
        const bool again = s > 2 * radius * c && (from + along * (2 * radius * c)).x > 0;
        if (!(s > 0) || again || s * std::tan(elevation) > wall) continue;
        lit.lux += lux * std::sin(elevation) * radius * c / std::abs(radius * c - 2 * s);
        lit.off_fold = std::min(lit.off_fold, std::abs(1 - 2 * s / (radius * c)));
    }
    return lit;
}

} // namespace

TEST(Caustics, OfACircularMirrorAreThoseOfTheMirrorEquation) {
    const CausticStage stage = half_mirror();
    const PreparedRig rig(stage.rig);
    const Caustics caustics(stage.tracer, stage.materials, rig, spec_of(1));
    test::Random random(4);
    int many = 0, off = 0;
    for (int i = 0; i < 300; ++i) {
        const Vec3 p(test::uniform(random, -80, 80), test::uniform(random, -80, 80), 0);
        const Lit lit = in_half_mirror(p);
        const double found = caustics.at(stage.piece(p))[0].g;
        many += lit.lux > 2.5 * lux;
        if (lit.off_fold > 0.02) {
            EXPECT_NEAR(found, lit.lux, 1e-6 * lit.lux + 1e-9) << p;
        } else {
            off += std::abs(found - lit.lux) > 1e-4 * lit.lux;
        }
    }
    EXPECT_GT(many, 5);
    EXPECT_LE(off, 1);
}

TEST(Caustics, OfABallLensAreThoseOfItsRays) {
    const CausticStage stage = ball_lens(sun_above());
    const PreparedRig rig(stage.rig);
    const Caustics caustics(stage.tracer, stage.materials, rig, spec_of(2));
    int lit = 0;
    for (const double rho : {0.5, 1.7, 3.1, 6.3, 9.2, 14.1, 19.7, 26.6}) {
        const double expected = under_ball(rho);
        lit += expected > lux;
        for (const double azimuth : {0.1, 1.9, 4.0}) {
            const Vec3 p(rho * std::cos(azimuth), rho * std::sin(azimuth), 0);
            EXPECT_NEAR(caustics.at(stage.piece(p))[0].g, expected, 2e-4 * expected) << rho;
        }
    }
    EXPECT_GT(lit, 2);
}

/// The axis meets both poles of the ball, where its tangents vanish: E = I (1 - F)^2 / (D - L D / f
/// + L)^2 on it, the lamp D before the middle, the floor L behind, and all differentials are lost.
TEST(Caustics, OnTheAxisOfABallLensAreThoseOfThinRays) {
    constexpr double focal = index * ball_radius / (2 * (index - 1)), far = 2000;
    const double passed = std::pow(1 - fresnel_dielectric(1, index), 2);
    const double thin = 1 - ball_height / focal, spread = far * thin + ball_height;
    const PointSource lamp{.position = {0, 0, ball_height + far}, .intensity = Rgb(7)};
    struct Case {
        LightSource light;
        double expected;
    };
    for (const auto& [light, expected] : {Case{sun_above(), lux * passed / (thin * thin)},
                                          Case{lamp, 7e6 * passed / (spread * spread)}}) {
        const CausticStage stage = ball_lens(light);
        const PreparedRig rig(stage.rig);
        for (const int detail : {127, 128}) {
            const Caustics caustics(stage.tracer, stage.materials, rig, spec_of(2, detail));
            for (const double x : {0.0, 1e-12, 1e-9, 1e-7, 1e-6, 1e-5, 1e-4})
                EXPECT_NEAR(caustics.at(stage.piece({x, -x / 3, 0}))[0].g, expected,
                            1e-8 * expected)
                    << x;
            const double seen = caustics.over(stage.piece({0, 0, 0}, 0.1)).incident.g;
            EXPECT_NEAR(seen, expected, 0.02 * expected) << detail;
        }
    }
}

/// A roof far above the ball keeps the sun from it.
TEST(Caustics, UnderARoofThereAreNone) {
    test::ShapeBuilder builder;
    builder.face(test::sphere({0, 0, ball_height}, ball_radius));
    builder.face({test::rectangle(-500, 500, -500, 500, 2500)});
    builder.face({test::rectangle(-400, 400, -400, 400, 0)});
    CausticStage stage(builder.model(), clear_glass(index));
    stage.rig.sources = {sun_above()};
    const PreparedRig rig(stage.rig);
    stage.materials[1] = stage.materials.back();
    const Caustics closed(stage.tracer, stage.materials, rig, spec_of(2));
    EXPECT_EQ(closed.flux_on(stage.floor()).g, 0);
    EXPECT_EQ(closed.at(stage.piece({0.5, 0, 0}))[0].g, 0);
}

/// Without windows the sun's light is what arrives at the scene: fog dims it only behind the ball.
TEST(Caustics, FogDimsSunlightFromTheFirstSurfaceOn) {
    CausticStage stage = ball_lens(sun_above());
    const PreparedRig clear(stage.rig);
    const Vec3 p(3.1, 0, 0);
    const double before =
        Caustics(stage.tracer, stage.materials, clear, spec_of(2)).at(stage.piece(p))[0].g;
    Medium fog;
    constexpr double extinction = 1;
    fog.extinction = Rgb(extinction);
    stage.rig.medium = fog;
    const PreparedRig foggy(stage.rig);
    const double after =
        Caustics(stage.tracer, stage.materials, foggy, spec_of(2)).at(stage.piece(p))[0].g;
    const double most = std::exp(-extinction * metres(ball_height - ball_radius));
    EXPECT_LT(after, before * most * 1.0001);
    EXPECT_GT(after, before * std::exp(-extinction * metres(ball_height)));
}

/// All that leaves the ball downwards arrives, without that of cells over the ball's outline, and
/// footprints share it out.
TEST(Caustics, LightIsNeitherLostNorAdded) {
    const CausticStage stage = ball_lens(sun_above());
    const PreparedRig rig(stage.rig);
    const auto landed = [](double b) {
        const Thrown ray = thrown(b);
        const double i = std::asin(b / ball_radius);
        const double mirrored = fresnel_dielectric(std::cos(i), index);
        double share = std::abs(ray.to) < floor_half ? ray.share : 0;
        // What the outside of the ball mirrors past 45 degrees lands farther out.
        const double to = b + std::tan(pi - 2 * i) * (ball_height + ball_radius * std::cos(i));
        if (i > pi / 4 && to < floor_half && mirrored >= 0.05) share += mirrored;
        return share * 2 * pi * b;
    };
    constexpr int steps = 20000;
    double sent = 0;
    for (int i = 0; i < steps; ++i)
        sent += landed(ball_radius * (i + 0.5) / steps) * ball_radius / steps;
    sent *= lux * metres(metres(1));
    for (const int detail : {64, 128}) {
        const Caustics caustics(stage.tracer, stage.materials, rig, spec_of(2, detail));
        const double found = caustics.flux_on(stage.floor()).g;
        const double smallest = 2 * ball_radius / detail / 4;
        const double outline = 2 * pi * ball_radius * smallest * lux * metres(metres(1));
        EXPECT_LT(found, (1 + 1e-4) * sent) << detail;
        EXPECT_GT(found, sent - outline) << detail;
        double sum = 0;
        constexpr double wide = 20;
        for (double x = wide / 2 - floor_half; x < floor_half; x += wide)
            for (double y = wide / 2 - floor_half; y < floor_half; y += wide)
                sum += caustics.over(stage.piece({x, y, 0}, wide)).incident.g;
        EXPECT_NEAR(sum * metres(metres(wide * wide)), found, 1e-9 * found);
    }
}

/// Photons by a seed, followed through the ball by its own geometry, not by patches.
TEST(Caustics, OfAPointThroughAbsorbingGlassAreThoseOfPhotons) {
    const PointSource lamp{.position = {90, 40, 320}, .intensity = Rgb(100)};
    const double absorption = 0.004;
    const CausticStage stage = ball_lens(lamp, absorption);
    const PreparedRig rig(stage.rig);
    const Caustics caustics(stage.tracer, stage.materials, rig, spec_of(2));
    const Vec3 center(0, 0, ball_height), way = center - lamp.position;
    const Vec3 axis = way.normalized(), beside = axis.cross(Vec3(1, 0, 0)).normalized();
    const double versine = 1 - std::sqrt(1 - std::pow(ball_radius / way.length(), 2));
    constexpr int photons = 3000000, cells = 24;
    constexpr double wide = 5, low = -120;
    std::vector<double> sum(cells * cells), square(cells * cells);
    test::Random random(8);
    for (int i = 0; i < photons; ++i) {
        const double c = 1 - versine * test::uniform(random, 0, 1);
        const double phi = test::uniform(random, 0, 2 * pi), s = std::sqrt(1 - c * c);
        Vec3 d = axis * c + (beside * std::cos(phi) + axis.cross(beside) * std::sin(phi)) * s;
        const double along = d.dot(way), square_off = way.length2() - along * along;
        Vec3 p = lamp.position +
                 d * (along - std::sqrt(std::max(0.0, ball_radius * ball_radius - square_off)));
        Vec3 n = (p - center) / ball_radius;
        double weight = 1 - fresnel_dielectric(-d.dot(n), index);
        d = *refract(d, n, 1 / index);
        const double chord = -2 * d.dot(p - center);
        p += d * chord, n = (p - center) / ball_radius;
        weight *= (1 - fresnel_dielectric(d.dot(n), 1 / index)) * std::exp(-absorption * chord);
        d = *refract(d, -n, index);
        p += d * (-p.z / d.z);
        const int x = static_cast<int>(std::floor((p.x - low) / wide));
        const int y = static_cast<int>(std::floor((p.y - low) / wide));
        if (!(d.z < 0) || x < 0 || y < 0 || x >= cells || y >= cells) continue;
        sum[y * cells + x] += weight, square[y * cells + x] += weight * weight;
    }
    const double lumen = 100 * 2 * pi * versine / photons, area = metres(metres(wide * wide));
    int lit = 0, off = 0;
    for (int y = 0; y < cells; ++y)
        for (int x = 0; x < cells; ++x) {
            const double counted = sum[y * cells + x];
            if (counted < 2000) continue;
            const Vec3 middle(low + (x + 0.5) * wide, low + (y + 0.5) * wide, 0);
            const double found = caustics.over(stage.piece(middle, wide)).incident.g;
            const double expected = counted * lumen / area;
            const double deviation = std::sqrt(square[y * cells + x]) * lumen / area;
            off += std::abs(found - expected) > 3 * deviation + 2e-3 * expected;
            EXPECT_NEAR(found, expected, 5 * deviation + 1e-2 * expected) << middle;
            ++lit;
        }
    EXPECT_GT(lit, 30);
    EXPECT_LE(off, lit / 30);
}

TEST(Caustics, AreTheSameForAnyNumberOfThreads) {
    const CausticStage stage =
        ball_lens(Spotlight{.position = {50, 0, 400}, .aim = {0, 0, ball_height}});
    const PreparedRig rig(stage.rig);
    const auto lux_with = [&](int threads) {
        const Caustics caustics(stage.tracer, stage.materials, rig, spec_of(4, 40),
                                {.progress = {}, .stop = {}, .threads = threads});
        std::vector<double> all;
        for (double x = -60; x < 60; x += 7)
            all.push_back(caustics.over(stage.piece({x, 3, 0}, 5)).incident.g);
        return all;
    };
    EXPECT_EQ(lux_with(1), lux_with(3));
}

/// A lamp in the middle of a mirrored tube lights all around it, by rays in all directions.
TEST(Caustics, OfALampAmongItsMirrorsComeFromAllSides) {
    test::ShapeBuilder builder;
    builder.face(test::cylinder(radius, wall));
    builder.face({test::rectangle(-400, 400, -400, 400, 0)});
    CausticStage stage(builder.model(), perfect_mirror());
    stage.rig.sources = {PointSource{.position = {0, 0, 100}, .intensity = Rgb(10)}};
    const PreparedRig rig(stage.rig);
    const Caustics caustics(stage.tracer, stage.materials, rig, spec_of(1));
    // All rays return through the axis, on ways of 2 R - rho and 2 R + rho over the floor. They
    // bring I h way / (d^3 rho), d the distance from the lamp's image.
    for (const double azimuth : {0.3, 1.2, 2.4, 4.9})
        for (const double rho : {20.0, 50.0, 75.0}) {
            const Vec3 p(rho * std::cos(azimuth), rho * std::sin(azimuth), 0);
            double expected = 0;
            for (const double flat : {2 * radius - rho, 2 * radius + rho}) {
                const double d = std::hypot(flat, 100.0);
                expected += 10 * 1e6 * 100 / (d * d * d) * flat / rho;
            }
            EXPECT_NEAR(caustics.at(stage.piece(p))[0].g, expected, 1e-6 * expected) << p;
        }
}

} // namespace keiko
