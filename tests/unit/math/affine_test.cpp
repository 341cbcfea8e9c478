#include "keiko/math/affine.h"

#include <gtest/gtest.h>

#include <numbers>

using namespace keiko;

namespace {

const Affine skewed_mirror{{Vec3(0, -2, 0.5), Vec3(1, 0.25, 0), Vec3(0, 0, -3)}, {10, 20, 30}};

void expect_near(const Vec3& a, const Vec3& b, double tolerance = 1e-14) {
    EXPECT_LE((a - b).length(), tolerance) << a << " against " << b;
}

} // namespace

TEST(Affine, InverseUndoes) {
    const Vec3 p(1.5, -7, 2);
    expect_near(skewed_mirror.inverse().point(skewed_mirror.point(p)), p);
    expect_near((skewed_mirror * skewed_mirror.inverse()).point(p), p);
}

TEST(Affine, ProductAppliesTheRightFactorFirst) {
    const Affine turn = Affine::rotate({0, 0, 1}, std::numbers::pi / 2);
    const Affine move = Affine::translate({1, 0, 0});
    expect_near((turn * move).point({1, 0, 0}), {0, 2, 0});
    expect_near((move * turn).point({1, 0, 0}), {1, 1, 0});
}

TEST(Affine, NormalIsTheCrossProductOfMappedTangents) {
    const Vec3 a(1, 2, 3), b(-2, 0.5, 1);
    expect_near(skewed_mirror.normal(a.cross(b)),
                skewed_mirror.vector(a).cross(skewed_mirror.vector(b)), 1e-12);
    EXPECT_TRUE(skewed_mirror.mirrored());
    EXPECT_FALSE(Affine::rotate({1, 1, 0}, 1).mirrored());
}

TEST(Affine, HomogeneousPointsMapLikePoints) {
    const Vec4 moved = skewed_mirror.homogeneous({2, 4, 6, 2});
    expect_near(Vec3(moved.x, moved.y, moved.z) / moved.w, skewed_mirror.point({1, 2, 3}));
}

TEST(Affine, RotationKeepsItsAxisAndTurnsRightHanded) {
    const Affine turn = Affine::rotate({1, 1, 1}, 2 * std::numbers::pi / 3);
    expect_near(turn.point({1, 0, 0}), {0, 1, 0});
    expect_near(turn.point({2, 2, 2}), {2, 2, 2});
}

TEST(Affine, TransformedBoxHoldsEveryMappedPoint) {
    const Box3 box{{-1, -2, -3}, {4, 5, 6}};
    const Box3 image = transformed(skewed_mirror, box).padded(1e-12);
    for (double s : {0.0, 0.3, 1.0})
        for (double t : {0.0, 0.7, 1.0})
            EXPECT_TRUE(
                image.contains(skewed_mirror.point(box.lower + box.extent() * Vec3(s, t, s * t))));
}
