#include "keiko/light/rig/prepared_rig.h"
#include "keiko/light/rig/surface_light.h"

#include <gtest/gtest.h>

#include <array>

using namespace keiko;

namespace {

const CPlane row{.origin = {-600, -500, 400},
                 .u = {1200, 0, 0},
                 .v = {0, 1000, 0},
                 .lamps = 5,
                 .luminance = {9000, 8000, 7000}};
const Spotlight spot{.position = {0, 0, 3000}, .aim = Vec3(0), .intensity = Rgb(5000)};
const Vec3 up(0, 0, 1);

/// A row of the one lamp alone, in its place.
CPlane alone(int lamp) {
    CPlane single = row;
    single.lamps = 1, single.pitch = row.spacing();
    single.origin.y = row.origin.y + lamp * row.spacing();
    single.v = {0, row.spacing(), 0};
    return single;
}

void expect_near(const Rgb& found, const Rgb& wanted) {
    EXPECT_NEAR(found.r, wanted.r, 1e-12 * wanted.r);
    EXPECT_NEAR(found.b, wanted.b, 1e-12 * wanted.b);
}

} // namespace

TEST(LightId, AreTheLampsOfRowsAndTheOtherSources) {
    const LightRig rig{.name = {}, .sources = {spot, row, Sun{}}};
    const std::vector<LightId> lights = PreparedRig(rig).lights;
    ASSERT_EQ(lights.size(), 7u);
    EXPECT_EQ(lights[0].source, 0u);
    EXPECT_EQ(lights[3].source, 1u);
    EXPECT_EQ(lights[3].lamp, 2);
    EXPECT_EQ(lights[6].source, 2u);
    EXPECT_EQ(lights[6].lamp, 0);
}

TEST(LightId, ComeASourceAtATime) {
    const std::vector<LightId> lights{{0, 2}, {0, 5}, {3, 0}};
    std::vector<std::size_t> firsts;
    each_source(lights, [&](std::size_t source, std::span<const int> lamps, std::size_t first) {
        firsts.push_back(first);
        EXPECT_EQ(source, lights[first].source);
        EXPECT_EQ(lamps.front(), lights[first].lamp);
        EXPECT_EQ(lamps.size(), source == 0 ? 2u : 1u);
    });
    EXPECT_EQ(firsts, (std::vector<std::size_t>{0, 2}));
}

TEST(LightId, EachLampLightsAsIfAlone) {
    const std::array some{1, 4};
    const Vec3 point(100, 50, 0);
    const auto seen = light_visibilities(row, some, point, up, Unoccluded(), TubeModel::automatic);
    const auto lx = illuminance_by_lamp(row, some, seen, {}, point, up, TubeModel::automatic);
    const Gloss gloss{{DistributionKind::trowbridge_reitz, 0.3}, GlossMode::lobe};
    const GlossKernel kernel(gloss, up, Vec3(0.3, 0, 1).normalized());
    const auto sent = glossy_luminance_by_lamp(row, some, seen, {}, point, kernel, Unoccluded());
    ASSERT_EQ(lx.size(), 2u);
    ASSERT_EQ(sent.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        const CPlane single = alone(some[i]);
        expect_near(lx[i], illuminance_from(single, {}, point, up, Unoccluded()));
        expect_near(sent[i], glossy_luminance_from(single, {}, point, kernel, Unoccluded()));
    }
}

/// Beside the row, where lamps hide each other: what a lamp leaves of its neighbour depends on the
/// row, not on the lamps that are queried.
TEST(LightId, LampsAddUpToTheirRow) {
    const Vec3 point(0, -1500, 390), normal = Vec3(0, 1, 0.2).normalized();
    const auto by_lamp = [&](std::span<const int> lamps) {
        constexpr TubeModel model = TubeModel::automatic;
        const auto seen = light_visibilities(row, lamps, point, normal, Unoccluded(), model);
        Rgb sum;
        for (const Rgb& lx : illuminance_by_lamp(row, lamps, seen, {}, point, normal, model))
            sum += lx;
        return sum;
    };
    const Rgb all = illuminance_from(row, {}, point, normal, Unoccluded());
    ASSERT_GT(all.g, 0);
    expect_near(by_lamp(std::array{0, 3}) + by_lamp(std::array{1, 2, 4}), all);
    expect_near(by_lamp(PreparedSource(row).lamp_numbers()), all);
}

TEST(LightVisibility, IsLinearBetweenPointsThatSeeTheSameNumberOfParts) {
    const LightVisibility a{IntervalSet({{0.1, 0.2}, {0.5, 1}}), 0.4};
    const LightVisibility b{IntervalSet({{0.3, 0.4}, {0.7, 1}}), 0.8};
    const auto amid = between(a, b, 0.25);
    ASSERT_TRUE(amid);
    EXPECT_NEAR(amid->share, 0.5, 1e-15);
    ASSERT_EQ(amid->axis.size(), 2u);
    EXPECT_NEAR(amid->axis[0].begin, 0.15, 1e-15);
    EXPECT_NEAR(amid->axis[1].begin, 0.55, 1e-15);
    EXPECT_FALSE(between(a, {IntervalSet::whole(), 1}, 0.5));
}

/// Sources that light nothing of the point are not queried: neither lamps below its horizon nor
/// beams that miss it.
TEST(LightVisibility, IsNothingOfWhatCannotReachThePoint) {
    const std::array one{0};
    const auto seen = [&](const LightSource& source, const Vec3& normal) {
        return light_visibilities(source, one, Vec3(0), normal, Unoccluded(),
                                  TubeModel::picture)[0];
    };
    for (const LightSource& source : {LightSource(row), LightSource(spot), LightSource(Sun{})}) {
        EXPECT_FALSE(seen(source, up).axis.empty());
        EXPECT_TRUE(seen(source, -up).axis.empty());
        EXPECT_EQ(seen(source, -up).share, 0);
    }
}
