#include "keiko/light/areas/area_coverage.h"

#include "keiko/light/rig/primitive_lights.h"
#include "keiko/light/rig/rig_areas.h"
#include "keiko/math/axes.h"

#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

/// An L of a panel: concave, aslant.
const PolygonLight angle{{{0, 0, 1000},
                          {600, 0, 1100},
                          {600, 200, 1100},
                          {200, 200, 1100.0 - 200.0 / 3},
                          {200, 500, 1100.0 - 200.0 / 3},
                          {0, 500, 1000}},
                         Rgb(100),
                         true};
const SphereLight globe{{100, -50, 900}, 300, Rgb(40)};

/// Rays that fan out of a place, a pixel wide and high by these.
RayDifferentials pixel(double across, double up) {
    RayDifferentials spread;
    spread.origin_dx = {across * 100, 0, 0};
    spread.direction_dx = {across, 0.2 * across, 0};
    spread.direction_dy = {-0.3 * up, up, 0.1 * up};
    return spread;
}

/// Mean over rays within a pixel.
template <class Light>
double mean_over_rays(const Light& light, const Vec3& origin, const Vec3& direction,
                      const RayDifferentials& spread) {
    constexpr int side = 60;
    int met = 0;
    for (int i = 0; i < side; ++i)
        for (int k = 0; k < side; ++k) {
            const double x = (i + 0.5) / side - 0.5, y = (k + 0.5) / side - 0.5;
            met += area_hit(light, origin + spread.origin_dx * x + spread.origin_dy * y,
                            direction + spread.direction_dx * x + spread.direction_dy * y, {})
                       .has_value();
        }
    return met / static_cast<double>(side * side);
}

template <class Light>
int compare_with_rays(const Light& light, double allowed) {
    int partly = 0;
    test::Random random(5);
    for (int i = 0; i < 200; ++i) {
        const Vec3 origin(test::uniform(random, -200, 200), test::uniform(random, -200, 200), 0);
        const Vec3 direction(test::uniform(random, -0.3, 0.6), test::uniform(random, -0.3, 0.5), 1);
        const RayDifferentials spread =
            pixel(test::uniform(random, 0.005, 0.02), test::uniform(random, 0.005, 0.02));
        const auto hit = area_hit(light, origin, direction, spread);
        const double coverage = hit ? hit->coverage : 0;
        partly += coverage > 0.01 && coverage < 0.99;
        EXPECT_NEAR(coverage, mean_over_rays(light, origin, direction, spread), allowed) << i;
    }
    return partly;
}

/// Rays of a pixel are not quite a parallelogram on a plane aslant, nor is a sphere's outline that
/// of its middle from all of a pixel.
TEST(AreaCoverage, IsTheMeanOverTheRaysOfAPixel) {
    EXPECT_GT(compare_with_rays(PanelOutline(angle), 0.01), 2);
    EXPECT_GT(compare_with_rays(globe, 0.02), 2);
    EXPECT_GT(compare_with_rays(DiscLight{{150, 50, 900}, Vec3(0.6, 0, -0.8), 350}, 0.02), 2);
    EXPECT_GT(compare_with_rays(
                  EllipsoidLight{{100, -50, 900}, {300, 0, 100}, {0, 200, 0}, {-50, 0, 150}}, 0.02),
              2);
    EXPECT_GT(compare_with_rays(FrustumLight{{-100, -50, 900}, {400, 200, 1100}, 150, 250}, 0.02),
              2);
    EXPECT_GT(compare_with_rays(FrustumLight{{100, 50, 900}, {150, 80, 1300}, 100, 500}, 0.02), 2);
}

/// A ray meets the part ahead of a cone that flares behind the eye.
TEST(AreaCoverage, ConesBesideTheEyeAreMetAhead) {
    struct Case {
        FrustumLight cone;
        Vec3 eye, way;
    };
    for (const Case& c : {Case{{{0, 0, 100}, {0, 0, 0}, 0, 1000}, {600, 0, 50}, {1, 0, -0.3}},
                          Case{{{0, 0, 300}, {0, 0, 0}, 150, 500}, {400, 0, 200}, {0.3, 0, -1}},
                          Case{{{0, 0, 200}, {0, 0, 0}, 60, 250}, {150, 0, 150}, {0.15, 0, -1}}}) {
        const double height = c.cone.from.z;
        const auto outside = [&](double t) {
            const Vec3 at = c.eye + c.way * t;
            const double grown = (c.cone.to_radius - c.cone.radius) * (1 - at.z / height);
            return at.x - (c.cone.radius + grown);
        };
        double low = 0, high = -c.eye.z / c.way.z;
        ASSERT_GT(outside(low), 0);
        ASSERT_LT(outside(high), 0);
        for (int i = 0; i < 100; ++i) {
            const double middle = (low + high) / 2;
            (outside(middle) > 0 ? low : high) = middle;
        }
        const auto ray = area_hit(c.cone, c.eye, c.way, {});
        ASSERT_TRUE(ray);
        EXPECT_NEAR(ray->t, low, 1e-9 * low);
        const auto pixel_of = area_hit(c.cone, c.eye, c.way, pixel(1e-4, 1e-4));
        ASSERT_TRUE(pixel_of);
        EXPECT_NEAR(pixel_of->coverage, 1, 1e-9);
    }
}

TEST(AreaCoverage, IsWholeWithinAndNothingBeside) {
    const RayDifferentials spread = pixel(1e-3, 1e-3);
    const PanelOutline outline(angle);
    const auto within = area_hit(outline, Vec3(0), {0.1, 0.1, 1}, spread);
    ASSERT_TRUE(within);
    EXPECT_NEAR(within->coverage, 1, 1e-12);
    EXPECT_NEAR(within->t, 1000 + within->t * 0.1 / 6, 1e-9);
    EXPECT_FALSE(area_hit(outline, Vec3(0), {0.45, 0.4, 1}, spread)); // between both arms
    EXPECT_FALSE(area_hit(outline, Vec3(0), {0.1, 0.1, -1}, spread)); // away
    const auto sphere = area_hit(globe, Vec3(0), {0.1, -0.05, 0.9}, spread);
    ASSERT_TRUE(sphere);
    EXPECT_NEAR(sphere->coverage, 1, 1e-12);
    EXPECT_FALSE(area_hit(globe, Vec3(0), {0.9, 0, 0.9}, spread));
    EXPECT_FALSE(area_hit(globe, globe.center, {0, 0, 1}, spread)); // from inside
}

TEST(AreaCoverage, HalfAPixelAtAStraightSideIsHalf) {
    const PanelOutline panel(PolygonLight{
        {{-500, 0, 100}, {500, 0, 100}, {500, 500, 100}, {-500, 500, 100}}, Rgb(1), true});
    RayDifferentials spread;
    spread.direction_dx = {0.01, 0, 0}, spread.direction_dy = {0, 0.01, 0};
    EXPECT_NEAR(area_hit(panel, Vec3(0), {0, 0, 1}, spread)->coverage, 0.5, 1e-12);
    EXPECT_NEAR(area_hit(panel, Vec3(0), {0, 0.0025, 1}, spread)->coverage, 0.75, 1e-12);
}

TEST(AreaCoverage, DarkFacesAreNotSeen) {
    PolygonLight panel{{{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};
    EXPECT_FALSE(area_hit(PanelOutline(panel), Vec3(0), {0, 0, 1}, {}));
    EXPECT_TRUE(area_hit(PanelOutline(panel), Vec3(0, 0, 2), {0, 0, -1}, {}));
    panel.two_sided = true;
    EXPECT_TRUE(area_hit(PanelOutline(panel), Vec3(0), {0, 0, 1}, {}));
}

/// The nearest comes first, wherever it stands in the rig; a surface hides what is behind it.
TEST(RigAreas, NearestComesFirst) {
    const PolygonLight panel{
        {{-500, -500, 2000}, {500, -500, 2000}, {500, 500, 2000}, {-500, 500, 2000}}, Rgb(7), true};
    LightRig rig;
    rig.sources = {panel, globe, Sun{}};
    const RigAreas areas(rig);
    EXPECT_FALSE(areas.empty());
    EXPECT_EQ(areas.boxes().size(), 2U);
    const Vec3 up(0.1, -0.05, 1);
    const auto both = areas.along(Vec3(0), up, {}, 1e9);
    ASSERT_EQ(both.size(), 2U);
    EXPECT_EQ(both[0].luminance, globe.luminance);
    EXPECT_EQ(both[1].luminance, panel.luminance);
    EXPECT_LT(both[0].hit.t, both[1].hit.t);
    EXPECT_EQ(areas.along(Vec3(0, 0, 1300), up, {}, 1e9).size(), 1U);
    EXPECT_TRUE(areas.along(Vec3(0), up, {}, 100).empty());
    EXPECT_TRUE(RigAreas(LightRig{}).empty());
}

/// Share of a pixel that some lights leave dark, towards +z.
double dark_share(std::vector<LightSource> lights, const Vec3& direction) {
    LightRig rig;
    rig.sources = std::move(lights);
    RayDifferentials spread;
    spread.direction_dx = {0.01, 0, 0}, spread.direction_dy = {0, 0.01, 0};
    double dark = 1;
    for (const RigAreas::Layer& layer : RigAreas(rig).along(Vec3(0), direction, spread, 1e9))
        dark *= 1 - layer.hit.coverage;
    return dark;
}

/// A face from the edge x = 0 at z = `depth` on, to x = `side` 500 and 300 mm farther away.
PolygonLight face(double side, double depth) {
    const double x = 500 * side, far = depth + 300;
    return {{{0, -500, depth}, {x, -500, far}, {x, 500, far}, {0, 500, depth}}, Rgb(1), true};
}

/// The edge of a box of light is as bright as its faces, wherever it cuts a pixel, to the
/// difference of footprints on two planes. Independent faces would leave a quarter of it dark.
TEST(RigAreas, FacesThatMeetLeaveNothingDark) {
    for (double x = -0.006; x < 0.006; x += 0.001)
        EXPECT_NEAR(dark_share({face(-1, 1000), face(1, 1000)}, {x, 0.01, 1}), 0, 3e-3) << x;
}

/// The side of a cylinder and its end share the pixels along the rim, seen from any side of it.
TEST(RigAreas, SideAndEndOfACylinderLeaveNothingDark) {
    constexpr double of_chords = 8e-3; // rims are chords, to a 500th of the pixel on either side
    const Vec3 end(-20, 10, 800);
    for (const Vec3& axis : {Vec3(0.6, -0.3, -0.74), Vec3(1, 0.2, -0.04), Vec3(0.1, 1, -0.1)}) {
        const Vec3 along = axis.normalized();
        LightRig rig;
        rig.sources = lights_of(FrustumShape{end - along * 400, end, 90, 90, false}, Rgb(1));
        const RigAreas areas(rig);
        RayDifferentials spread;
        spread.direction_dx = {0.003, 0, 0}, spread.direction_dy = {0, 0.003, 0};
        const Vec3 x = any_perpendicular(along).normalized(), y = along.cross(x);
        int shared = 0;
        for (int i = 0; i < 360; ++i) {
            const double turn = i * std::numbers::pi / 180;
            const Vec3 out = x * std::cos(turn) + y * std::sin(turn), rim = end + out * 90;
            if (out.dot(end) > -0.8 * square_to(end, along).length())
                continue; // near the outline, or behind
            for (const double aside : {-0.001, -0.0003, 0.0003, 0.001}) {
                const Vec3 direction = rim / rim.z + Vec3(aside, aside / 2, 0);
                double dark = 1;
                const auto layers = areas.along(Vec3(0), direction, spread, 1e9);
                for (const RigAreas::Layer& layer : layers) dark *= 1 - layer.hit.coverage;
                EXPECT_NEAR(dark, 0, of_chords) << axis << i << ' ' << aside;
                shared += layers.size() > 1 && layers[0].hit.coverage < 0.9;
            }
        }
        EXPECT_GT(shared, 20) << axis;
    }
}

/// Lights at other distances cover a pixel independently of each other.
TEST(RigAreas, LightsFarBehindAnEdgeFillTheirShareOfWhatItLeaves) {
    EXPECT_NEAR(dark_share({face(-1, 1000), face(1, 2000)}, {0, 0.01, 1}), 0.25, 1e-12);
}

} // namespace
} // namespace keiko
