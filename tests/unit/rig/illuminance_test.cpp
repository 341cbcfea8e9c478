#include "keiko/rig/illuminance.h"

#include "keiko/fog/transmittance.h"
#include "keiko/luminance/clear_coat.h"
#include "keiko/spotlight/beam_intensity.h"
#include "keiko/tubes/tube_irradiance.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace keiko;

namespace {

const CPlane row{.origin = {-600, -500, 2000},
                 .u = {1200, 0, 0},
                 .v = {0, 1000, 0},
                 .lamps = 4,
                 .luminance = {9000, 8000, 7000}};
const Spotlight spot{.position = {0, 0, 3000}, .aim = Vec3(0), .intensity = Rgb(5000)};
const Vec3 up(0, 0, 1);

/// Something is in the way of everything.
class AllHidden final : public Visible {
public:
    using Visible::intervals;
    IntervalSet intervals(const Segment&) const override { return {}; }
};

/// Hides the half of every segment that is nearer to its end a; counts the questions.
class HalfHidden final : public Visible {
public:
    using Visible::intervals;
    IntervalSet intervals(const Segment& segment) const override {
        ++asked;
        return segment.a == segment.b ? IntervalSet() : IntervalSet::whole(0.5, 1);
    }
    mutable int asked = 0;
};

LightRig rig_of(std::vector<LightSource> sources, std::optional<Medium> medium = {}) {
    return {.name = "",
            .sources = std::move(sources),
            .ambient = Rgb(100),
            .medium = std::move(medium)};
}

} // namespace

TEST(DirectIlluminance, SumsOverAllSourcesWithoutTheAmbientLight) {
    const LightRig rig = rig_of({row, spot});
    const auto parts = illuminance_by_source(rig, Vec3(0), up, AllVisible());
    ASSERT_EQ(parts.size(), 2u);
    Rgb lamps;
    for (const TubeLamp& lamp : lamps_of(row)) lamps += irradiance(lamp, Vec3(0), up);
    EXPECT_NEAR(parts[0].r, lamps.r, 1e-12 * lamps.r);
    EXPECT_NEAR(parts[0].b, lamps.b, 1e-12 * lamps.b);
    EXPECT_NEAR(parts[1].g, 5000 / 9.0, 1e-10);
    EXPECT_EQ(direct_illuminance(rig, Vec3(0), up, AllVisible()), parts[0] + parts[1]);
}

TEST(DirectIlluminance, CountsWhatIsSeenOnly) {
    const LightRig rig = rig_of({row, spot});
    const auto open = illuminance_by_source(rig, Vec3(0), up, AllVisible());
    const auto half = illuminance_by_source(rig, Vec3(0), up, HalfHidden());
    EXPECT_NEAR(half[0].r, open[0].r / 2, 1e-10 * open[0].r) << "by symmetry";
    EXPECT_EQ(half[1], Rgb());
}

TEST(DirectIlluminance, DoesNotAskForWhatCannotReachThePoint) {
    const HalfHidden visible;
    const LightRig rig = rig_of({row, spot});
    EXPECT_EQ(direct_illuminance(rig, Vec3(0), -up, visible), Rgb());
    EXPECT_EQ(visible.asked, 0);
    direct_illuminance(rig, Vec3(2500, 0, 0), up, visible); // outside the beam
    constexpr int lamps = 4, sub_axes = 7;
    EXPECT_EQ(visible.asked, lamps * sub_axes);
}

TEST(DirectIlluminance, IsAttenuatedOnItsWay) {
    const Medium medium{.extinction = {0, 0.1, 0.5}};
    const auto clear = illuminance_by_source(rig_of({row, spot}), Vec3(0), up, AllVisible());
    const auto foggy =
        illuminance_by_source(rig_of({row, spot}, medium), Vec3(0), up, AllVisible());
    EXPECT_NEAR(foggy[1].b, clear[1].b * std::exp(-1.5), 1e-10);
    EXPECT_NEAR(foggy[0].r, clear[0].r, 1e-9 * clear[0].r) << "the pieces make the whole";
    // Lamps are 2 m and more away, those that count little more.
    EXPECT_LT(foggy[0].b, clear[0].b * std::exp(-1.0));
    EXPECT_GT(foggy[0].b, clear[0].b * std::exp(-1.15));
}

TEST(DirectIlluminance, PiecesInFogAreFineEnough) {
    // One lamp through dense fog against 400 pieces of it.
    CPlane single = row;
    single.lamps = 1;
    const Medium medium{.extinction = Rgb(1)};
    const TubeLamp lamp = lamps_of(single)[0];
    double fine = 0;
    for (int i = 0; i < 400; ++i) {
        const double begin = i / 400.0, end = i == 399 ? 1 : (i + 1) / 400.0;
        const Vec3 middle = lamp.a + (lamp.b - lamp.a) * ((begin + end) / 2);
        fine += irradiance(lamp, Vec3(0), up, IntervalSet::whole(begin, end)).g *
                transmittance(medium, {Vec3(0), middle}).g;
    }
    EXPECT_NEAR(illuminance_from(single, medium, Vec3(0), up, AllVisible()).g, fine, 5e-4 * fine);
}

TEST(DirectIlluminance, ARowThatNamesItsModelKeepsIt) {
    CPlane near = row;
    near.origin.z = 200;
    const auto lux = [&](TubeModel own, TubeModel asked) {
        near.diffuse = own;
        return illuminance_from(near, {}, Vec3(0), up, AllVisible(), asked).g;
    };
    const double seed = lux(TubeModel::automatic, TubeModel::seed);
    EXPECT_EQ(lux(TubeModel::seed, TubeModel::automatic), seed);
    EXPECT_NE(lux(TubeModel::automatic, TubeModel::automatic), seed);
}

TEST(DirectIlluminance, TheSunIsParallelAndMayBeHidden) {
    const Sun sun{.direction = {0, 3, -4}, .illuminance = {50000, 40000, 30000}};
    const auto lux = [&](const Vec3& normal, const Visible& visible) {
        return illuminance_from(sun, Medium{.extinction = Rgb(5)}, Vec3(7, 8, 9), normal, visible);
    };
    EXPECT_NEAR(lux(up, AllVisible()).r, 40000, 1e-9);
    EXPECT_NEAR(lux(Vec3(0, -1, 0), AllVisible()).b, 18000, 1e-9);
    EXPECT_EQ(lux(-up, AllVisible()), Rgb());
    EXPECT_EQ(lux(up, HalfHidden()), Rgb());
}

TEST(DirectIlluminance, CountsWhatEntersACoat) {
    // A lamp as long as the eye can see, its light weighted piece by piece.
    const ClearCoat coat(Rgb(0.5), 1.5);
    CPlane single = row;
    single.lamps = 1;
    const TubeLamp lamp = lamps_of(single)[0];
    double entered = 0;
    constexpr int pieces = 2000;
    const Vec3 normal = Vec3(0.9, 0.1, 0.3).normalized();
    for (int i = 0; i < pieces; ++i) {
        const double begin = i / static_cast<double>(pieces);
        const double end = i + 1 == pieces ? 1 : (i + 1.0) / pieces;
        const Vec3 to = lamp.a + (lamp.b - lamp.a) * ((begin + end) / 2);
        entered += irradiance(lamp, Vec3(0), normal, IntervalSet::whole(begin, end)).g *
                   coat.entering(std::max(0.0, normal.dot(to.normalized())));
    }
    const double lit =
        illuminance_from(single, {}, Vec3(0), normal, AllVisible(), TubeModel::automatic, &coat).g;
    const double all = illuminance_from(single, {}, Vec3(0), normal, AllVisible()).g;
    EXPECT_NEAR(lit, entered, 2e-3 * (all - entered));
    EXPECT_LT(lit, 0.96 * all);
    const Rgb spotted =
        illuminance_from(spot, {}, Vec3(0), up, AllVisible(), TubeModel::automatic, &coat);
    EXPECT_NEAR(spotted.g, 0.96 * 5000 / 9.0, 1e-9);
}

/// Beyond the end of a lamp, within its radius, the cap alone lights.
TEST(IlluminanceFrom, ACapIsHiddenToo) {
    const CPlane capped{.origin = {0, -50, 1000},
                        .u = {500, 0, 0},
                        .v = {0, 100, 0},
                        .lamps = 1,
                        .luminous_caps = true};
    const Vec3 beside(-20, 0, 1000), towards(1, 0, 0);
    EXPECT_GT(illuminance_from(capped, {}, beside, towards, AllVisible()).r, 0);
    EXPECT_EQ(illuminance_from(capped, {}, beside, towards, AllHidden()).r, 0);
}
