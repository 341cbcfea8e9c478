#include "keiko/geometry/rays/contour_arc.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace keiko {
namespace {

using std::numbers::pi;

/// A circle of directions about an axis aslant, by an angle; and the plane that touches it there.
Vec3 on_cone(double angle) {
    return {0.5 + 0.4 * std::cos(angle), -0.2 + 0.4 * std::sin(angle), 1};
}
Vec3 plane_at(double angle) {
    return on_cone(angle).cross(Vec3(-std::sin(angle), std::cos(angle), 0));
}

std::vector<ContourArc> circle(int arcs) {
    std::vector<ContourArc> all;
    for (int i = 0; i < arcs; ++i) {
        const double from = 2 * pi * i / arcs, to = 2 * pi * (i + 1) / arcs;
        all.push_back(arc_through(on_cone(from), on_cone(from + 0.4 * (to - from)), on_cone(to),
                                  plane_at(from), plane_at(to)));
    }
    return all;
}

TEST(ContourArc, IsACircleThroughItsPlacesAndPlanes) {
    for (const ContourArc& arc : circle(3))
        for (double t = 0; t <= 1; t += 0.05) {
            const Vec3 at = arc.at(t) / arc.at(t).z;
            EXPECT_NEAR(std::hypot(at.x - 0.5, at.y + 0.2), 0.4, 1e-14);
        }
    EXPECT_NEAR(circle(4)[1].angle_off(on_cone(2.2)), 0, 1e-8);
    EXPECT_GT(circle(4)[1].angle_off(on_cone(2.2) * 1.01 - Vec3(0, 0, 0.01)), 1e-4);
    EXPECT_FALSE(circle(4)[1].nearest(-on_cone(2.2)));
}

/// Each plane enters as often as it leaves, at places of the circle and of the plane.
TEST(ContourArc, PlanesCrossAClosedOutlineEvenly) {
    for (int i = 0; i < 200; ++i) {
        const Vec3 normal(std::sin(1.7 * i), std::cos(2.3 * i), 0.6 * std::sin(0.9 * i));
        int rising = 0, falling = 0;
        for (const ContourArc& arc : circle(5))
            for (const ArcRoot& root : arc.crossings(normal)) {
                ++(root.rises ? rising : falling);
                EXPECT_NEAR(arc.at(root.t).normalized().dot(normal), 0, 1e-14);
            }
        EXPECT_EQ(rising, falling) << i;
        // Distance of the plane's line from the circle's middle, in its picture at z = 1.
        const double off =
            std::abs(normal.dot(Vec3(0.5, -0.2, 1))) / std::hypot(normal.x, normal.y);
        EXPECT_EQ(rising, off < 0.4 ? 1 : 0) << i;
    }
}

/// Zero counts as above, so that an arc that leaves a plane to its upper side enters it later.
TEST(ContourArc, ArcThatBeginsInAPlaneCrossesItWhereItsSideChanges) {
    for (const auto& [middle, end, at] :
         {std::array{1.0, -1.0, 2.0 / 3}, {0.5, -3.0, 0.25}, {-1.0, -1.0, 0.0}, {0.0, -1.0, 0.0}}) {
        const ContourArc arc{{0, 0, 1}, {middle, 1, 1}, {end, 2, 1}};
        const ContourArc::Crossings crossed = arc.crossings({1, 0, 0});
        ASSERT_EQ(crossed.count, 1U) << middle;
        EXPECT_NEAR(crossed.of[0].t, at, 1e-15) << middle;
        EXPECT_FALSE(crossed.of[0].rises);
    }
    const ContourArc back{{-1, 0, 1}, {1, 1, 1}, {0, 2, 1}};
    ASSERT_EQ(back.crossings({1, 0, 0}).count, 1U);
    EXPECT_NEAR(back.crossings({1, 0, 0}).of[0].t, 1.0 / 3, 1e-15);
}

TEST(ContourArc, PartsAreTheArc) {
    const ContourArc arc = circle(3)[0], part = arc.part(0.3, 0.8);
    for (const double t : {0.0, 0.4, 1.0})
        EXPECT_NEAR(angle_between(part.at(t), arc.at(0.3 + 0.5 * t)), 0, 1e-14);
}

TEST(ContourArc, ExtremesAreWhereAPlaneAboutTheAxisTouches) {
    std::vector<double> slopes;
    for (const ContourArc& arc : circle(5))
        for (const ArcRoot& root : arc.extremes({0, 0, 1}, {0, 1, 0})) {
            const Vec3 at = arc.at(root.t);
            slopes.push_back(at.y / at.z);
        }
    ASSERT_EQ(slopes.size(), 2U);
    EXPECT_NEAR(std::max(slopes[0], slopes[1]), 0.2, 1e-14);
    EXPECT_NEAR(std::min(slopes[0], slopes[1]), -0.6, 1e-14);
}

} // namespace
} // namespace keiko
