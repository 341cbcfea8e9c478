#include "keiko/math/affine.h"
#include "keiko/placement/candidate_planes.h"

#include <gtest/gtest.h>

#include <numbers>

namespace keiko {
namespace {

const OrientedBox cube = oriented(Box3{Vec3(-1), Vec3(1)});

TEST(OrientedBox, AxisParallelBoxesOverlapAsBoundsDo) {
    EXPECT_TRUE(overlap(cube, oriented(Box3{Vec3(0.5), Vec3(2)})));
    EXPECT_FALSE(overlap(cube, oriented(Box3{Vec3(1.01), Vec3(2)})));
    EXPECT_FALSE(overlap(cube, oriented(Box3{Vec3(-9, -9, 1.01), Vec3(9, 9, 2)})));
    EXPECT_TRUE(overlap(cube, oriented(Box3{Vec3(-9), Vec3(9)}))); // one in the other
}

TEST(OrientedBox, ATurnedFlatBoxPassesBesideACorner) {
    // The plane x + y = d cuts the cube where d < 2.
    const auto diagonal = [](double d) {
        const Vec3 across = Vec3(1, -1, 0) * 5.0;
        return oriented(CPlane{.origin = Vec3(d / 2, d / 2, -5) - across / 2.0,
                               .u = {0, 0, 10},
                               .v = across,
                               .diameter = 0});
    };
    EXPECT_TRUE(overlap(cube, diagonal(1.99)));
    EXPECT_FALSE(overlap(cube, diagonal(2.01)));
}

TEST(OrientedBox, EdgesCrossingInSpaceAreToldApart) {
    // A rod that passes the cube's edge y = z = 1 aslant: only the cross axis separates them.
    const auto rod = [](double distance) {
        const Affine turn = Affine::rotate({1, 0, 0}, -std::numbers::pi / 4) *
                            Affine::rotate({0, 0, 1}, std::numbers::pi / 4);
        OrientedBox box;
        for (std::size_t i = 0; i < 3; ++i) box.axes[i] = turn.vector(cube.axes[i]);
        box.half = {0.01, 20, 0.01};
        const Vec3 away = Vec3(1, 0, 0).cross(box.axes[1]).normalized();
        box.center = Vec3(0, 1, 1) + (away.dot(Vec3(0, 1, 1)) > 0 ? away : -away) * distance;
        return box;
    };
    EXPECT_FALSE(overlap(cube, rod(0.1)));
    EXPECT_TRUE(overlap(cube, rod(-0.1)));
}

TEST(OrientedBox, HoldsTheLampsOfACPlane) {
    const CPlane plane{.origin = {1, 2, 3}, .u = {0, 4, 0}, .v = {6, 0, 0}, .diameter = 2};
    const OrientedBox box = oriented(plane);
    EXPECT_EQ(box.center, Vec3(4, 4, 3));
    EXPECT_EQ(box.half, Vec3(2, 3, 1));
}

} // namespace
} // namespace keiko
