#include "keiko/light/rig/rig_planes.h"
#include "keiko/light/rig/surface_light.h"
#include "keiko/light/tubes/tube_hit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace keiko;

namespace {

const CPlane row{.origin = {-600, -500, 2000},
                 .u = {1200, 0, 0},
                 .v = {0, 1000, 0},
                 .lamps = 4,
                 .luminance = {9000, 8000, 7000}};
const Vec3 up(0, 0, 1);

LightRig rig_of(std::vector<LightSource> sources) {
    return {.name = "", .sources = std::move(sources), .ambient = Rgb(0), .medium = {}};
}

class NothingVisible final : public Visibility {
public:
    using Visibility::intervals;
    IntervalSet intervals(const Segment&) const override { return {}; }
};

} // namespace

TEST(GlossyLuminance, AVeryNarrowLobeIsAMirror) {
    const LightRig rig = rig_of({row});
    const Gloss gloss{.distribution = {DistributionKind::beckmann, 0.0005}};
    int lit = 0;
    for (double y = -115; y < -55; y += 0.5) {
        const Vec3 eye = Vec3(0.1, 0.02, 1).normalized();
        const Vec3 point(0, y, 0);
        const Rgb sharp = RigPlanes(rig).luminance(point, reflect(-eye, up)).luminance;
        // A lamp's edge is blurred over a few mm.
        const Rgb beside =
            RigPlanes(rig).luminance(point + Vec3(0, 9, 0), reflect(-eye, up)).luminance;
        const Rgb before =
            RigPlanes(rig).luminance(point - Vec3(0, 9, 0), reflect(-eye, up)).luminance;
        if (!(sharp == beside && sharp == before)) continue;
        const Rgb seen = glossy_luminance(rig, point, GlossKernel(gloss, up, eye), Unoccluded());
        EXPECT_NEAR(seen.r, sharp.r, 0.01 * row.luminance.r) << y;
        lit += seen.r > 0.9 * row.luminance.r;
    }
    EXPECT_GT(lit, 8);
}

TEST(GlossyLuminance, SourcesAddUpAndCanBeHidden) {
    const Spotlight spot{.position = {0, 0, 3000}, .aim = Vec3(0), .intensity = Rgb(5000)};
    const Sun sun{.direction = {0, 0, -1}, .illuminance = Rgb(1000)};
    const Gloss gloss{.distribution = {DistributionKind::trowbridge_reitz, 0.3},
                      .mode = GlossMode::brdf,
                      .shadowing = Shadowing::smith,
                      .reflectance = Reflectance::dielectric(1.5)};
    const GlossKernel kernel(gloss, up, Vec3(0.3, 0, 1).normalized());
    const auto seen = [&](std::vector<LightSource> sources, const Visibility& visible) {
        return glossy_luminance(rig_of(std::move(sources)), Vec3(0), kernel, visible).g;
    };
    const Unoccluded open;
    const double lamps = seen({row}, open), beam = seen({spot}, open), day = seen({sun}, open);
    EXPECT_NEAR(beam, kernel(up).g * 5000 / 9, 1e-9 * beam);
    EXPECT_NEAR(day, kernel(up).g * 1000, 1e-9 * day);
    EXPECT_GT(lamps, 0);
    EXPECT_NEAR(seen({row, spot, sun}, open), lamps + beam + day, 1e-9 * (lamps + beam + day));
    EXPECT_EQ(seen({row, spot, sun}, NothingVisible()), 0);
}

TEST(GlossyLuminance, FlakesBrightenTowardsTheMirrorDirection) {
    const LightRig rig = rig_of({row});
    const Flakes flakes;
    const auto seen = [&](const Vec3& eye) {
        return glossy_luminance(rig, Vec3(0), FlakeKernel(flakes, up, eye.normalized()),
                                Unoccluded())
            .g;
    };
    EXPECT_GT(seen({0, 0, 1}), 2 * seen({1.5, 0, 1}));
}

TEST(LobeReach, NoLampThatTheConeMeetsIsLeftOut) {
    std::mt19937 random(8);
    std::uniform_real_distribution<double> any(-1, 1);
    CPlane plane = row;
    plane.lamps = 30;
    plane.v = {0, 6000, 0};
    plane.origin.y = -3000;
    const CPlaneFrame frame(plane);
    int left_out = 0;
    for (int i = 0; i < 3000; ++i) {
        const Vec3 point(500 * any(random), 2000 * any(random), 900 * any(random));
        const Vec3 axis =
            Vec3(any(random), any(random), 0.2 + 0.8 * std::abs(any(random))).normalized();
        const double half = 0.02 + 0.5 * std::abs(any(random));
        const LampRange range = lamps_in_cone(frame, point, axis, half);
        left_out += frame.lamps - (range.end - range.begin);
        const TubeLamp lamp = lamp_of(frame, i % frame.lamps, Rgb());
        const double t = std::abs(any(random));
        const Vec3 at = lamp.a + (lamp.b - lamp.a) * t +
                        Vec3(0, any(random), any(random)).normalized() * frame.radius();
        if (angle_between(at - point, axis) > half) continue;
        EXPECT_LE(range.begin, i % frame.lamps);
        EXPECT_GT(range.end, i % frame.lamps);
    }
    EXPECT_GT(left_out, 3000);
}
