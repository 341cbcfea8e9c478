#include "keiko/light/rig/rig_planes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace keiko;

namespace {

CPlane row_at(double height, const Rgb& luminance) {
    return {.origin = {-500, -500, height},
            .u = {1000, 0, 0},
            .v = {0, 1000, 0},
            .lamps = 10,
            .diameter = 50,
            .luminance = luminance};
}

LightRig rig_of(std::vector<LightSource> sources) {
    return {.name = "", .sources = std::move(sources), .ambient = Rgb(0), .medium = {}};
}

const Rgb red(100, 0, 0), blue(0, 0, 100);
const Vec3 up(0, 0, 1);

/// A pixel that spans several pitches of any row: half of it is lamps.
const RayDifferentials wide{Vec3(0), Vec3(0), {0.01, 0, 0}, {0, 0.2, 0}};

} // namespace

TEST(RigPlanes, SeesTheNearestLampAndWhatShowsBetween) {
    CPlane shifted = row_at(1000, blue);
    shifted.origin.y += 25;
    const LightRig rig = rig_of({Spotlight(), row_at(2000, red), shifted});
    const auto at = [&](double y) { return RigPlanes(rig).luminance(Vec3(0, y, 0), up).luminance; };
    EXPECT_EQ(at(70), blue);  // both
    EXPECT_EQ(at(90), blue);  // the near row only
    EXPECT_EQ(at(30), red);   // the far row only
    EXPECT_EQ(at(10), Rgb()); // between
}

TEST(RigPlanes, NearRowsCoverTheirShareOfThoseBehind) {
    const LightRig rig = rig_of({row_at(2000, red), row_at(1000, blue)});
    const MirroredLight light = RigPlanes(rig).luminance(Vec3(0), up, wide);
    EXPECT_NEAR(light.luminance.b, 50, 1e-9);
    EXPECT_NEAR(light.luminance.r, 25, 1e-9);
    EXPECT_NEAR(light.coverage, 0.75, 1e-12);
    EXPECT_TRUE(light.resolved);
}

TEST(RigPlanes, RowsInOnePlaneAreAllSeen) {
    CPlane right = row_at(1000, red);
    right.origin.x += 1000;
    const LightRig rig = rig_of({row_at(1000, blue), right});
    EXPECT_EQ(RigPlanes(rig).luminance(Vec3(400, 50, 0), up).luminance, blue);
    EXPECT_EQ(RigPlanes(rig).luminance(Vec3(600, 50, 0), up).luminance, red);
}

TEST(RigPlanes, OfRowsInOneSlantedPlaneTheFirstIsTheNearest) {
    CPlane first{.origin = {10, 20, 1000}, .u = {1000, 0, 300}, .v = {-90, 800, 300}};
    CPlane second = first;
    second.origin += first.u * (1.0 / 3) + first.v * 0.7;
    second.v = first.v * 0.3;
    const LightRig rig = rig_of({first, second, first});
    const RigPlanes planes(rig);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 from(std::sin(i), std::cos(3 * i), 0.1 * i);
        const Vec3 direction(0.3 * std::sin(7 * i), 0.3 * std::cos(5 * i), 1);
        const auto hit = planes.nearest(from, direction);
        ASSERT_TRUE(hit);
        EXPECT_EQ(hit->number, 0) << i;
    }
}

TEST(RigPlanes, StopsAtTheNextSurface) {
    const LightRig rig = rig_of({row_at(2000, red), row_at(1000, blue)});
    const auto until = [&](double t) {
        return RigPlanes(rig).luminance(Vec3(0, 50, 0), up * 10, {}, t);
    };
    EXPECT_EQ(until(99).coverage, 0);
    EXPECT_EQ(until(101).luminance, blue);
    EXPECT_EQ(RigPlanes(rig).luminance(Vec3(0, 50, 1500), up, {}, 100).coverage, 0);
}

TEST(RigPlanes, TellsWhenStripesAreTooFine) {
    const RayDifferentials spread{Vec3(0), Vec3(0), {0.01, 0, 0}, {0, 0.5, 0}};
    EXPECT_FALSE(RigPlanes(rig_of({row_at(1000, red)})).luminance(Vec3(0), up, spread).resolved);
    EXPECT_TRUE(RigPlanes(rig_of({row_at(-1000, red)})).luminance(Vec3(0), up, spread).resolved);
}

TEST(RigPlanes, NearestCPlaneIsFoundBeyondItsRectangle) {
    const LightRig rig = rig_of({row_at(2000, red), Spotlight(), row_at(1000, blue)});
    const auto hit = RigPlanes(rig).nearest(Vec3(2000, 0, 0), up);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->source, 2u);
    EXPECT_DOUBLE_EQ(hit->at.u, 2500);
    EXPECT_DOUBLE_EQ(hit->at.v, 500);
    EXPECT_FALSE(RigPlanes(rig).nearest(Vec3(0), -up));
}
