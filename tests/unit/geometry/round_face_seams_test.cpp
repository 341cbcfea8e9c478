// Seams of cylinders, tori and spheres: closed faces, arcs and poles.
#include "keiko/geometry/seam/seam.h"

#include "tests/support/analytic_models.h"
#include "tests/unit/geometry/seam_sides.h"
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace keiko {
namespace {

using namespace test;

const double half_root = std::sqrt(0.5);

/// A quarter of a cylinder about z, in u from `from` quarter turns, in v along z.
std::vector<Vec4> quarter_cylinder(double radius, double height, int from) {
    const auto at = [&](double x, double y, double z, double w) {
        const int turns = from % 4;
        for (int i = 0; i < turns; ++i) std::swap(x, y), x = -x;
        return Vec4(radius * x * w, radius * y * w, z * w, w);
    };
    return {at(1, 0, 0, 1),         at(1, 0, height, 1),
            at(1, 1, 0, half_root), at(1, 1, height, half_root),
            at(0, 1, 0, 1),         at(0, 1, height, 1)};
}

TEST(PairSeams, JoinsAClosedFaceToItself) {
    // Four knot spans of one face: the natural side at u lowest meets the one at u highest.
    NurbsSurface tube{2, 1, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}, {0, 0, 1, 1}, {}};
    for (int quarter = 0; quarter < 4; ++quarter) {
        const auto points = quarter_cylinder(30, 80, quarter);
        tube.points.insert(tube.points.end(), points.begin() + (quarter == 0 ? 0 : 2),
                           points.end());
    }
    ModelBuilder builder;
    builder.nurbs(tube);
    const SurfaceModel model = builder.build();
    const auto seams = pair_seams(model, join);
    ASSERT_EQ(seams.size(), 1u);
    EXPECT_EQ(seams[0].a.face, seams[0].b.face);
    EXPECT_NEAR(length_of(model, seams[0].a), 80, 1e-10);
}

// Both ends of each border face both ends of the other.
TEST(PairSeams, JoinsATorusToItselfAllAround) {
    for (const double size : {1e-2, 1.0, 1e3}) {
        const SurfaceModel model = test::torus_model(60 * size, 20 * size, 0.3);
        double length = 0;
        for (const Seam& seam : pair_seams(model, size < 1 ? 0.01 : join)) {
            EXPECT_NEAR(length_of(model, seam.a), length_of(model, seam.b), 1e-9 * size);
            length += length_of(model, seam.a) / size;
        }
        const double pi = std::numbers::pi;
        EXPECT_NEAR(length, 2 * pi * (60 + 20 * std::cos(0.3) + 20), 1e-6) << size;
    }
}

TEST(PairSeams, JoinsBordersOfDifferentParametrisation) {
    // The rim of a quarter cylinder against the same arc, trimmed out of a plane by a p-curve.
    ModelBuilder builder;
    builder.rational_patch(2, 1, quarter_cylinder(30, 80, 0));
    builder.plane({0, 0, 0}, {100, 0, 0}, {0, 100, 0});
    const double r = 0.3;
    builder.loop({{Vec3(0, 0, 1), Vec3(r, 0, 1)},
                  {Vec3(r, 0, 1), Vec3(r, r, 1) * half_root, Vec3(0, r, 1)},
                  {Vec3(0, r, 1), Vec3(0, 0, 1)}});
    const SurfaceModel model = builder.build();
    const auto seams = pair_seams(model, join);
    ASSERT_EQ(seams.size(), 1u);
    EXPECT_EQ(seams[0].b, (BoundaryInterval{0, 1, 1, 0, 1}));
    EXPECT_NEAR(length_of(model, seams[0].a), 15 * std::numbers::pi, 1e-9);
}

TEST(PairSeams, SkipsBordersThatArePoints) {
    // Two octants of a sphere: they share a meridian and, as a point, the pole.
    const double w = half_root;
    const std::vector<Vec4> octant{{10, 0, 0, 1},
                                   {10 * w, 0, 10 * w, w},
                                   {0, 0, 10, 1},
                                   {10 * w, 10 * w, 0, w},
                                   {10 * w * w, 10 * w * w, 10 * w * w, w * w},
                                   {0, 0, 10 * w, w},
                                   {0, 10, 0, 1},
                                   {0, 10 * w, 10 * w, w},
                                   {0, 0, 10, 1}};
    std::vector<Vec4> next = octant;
    for (Vec4& p : next) p = Vec4(-p.y, p.x, p.z, p.w);
    ModelBuilder builder;
    builder.rational_patch(2, 2, octant);
    builder.rational_patch(2, 2, next);
    const SurfaceModel model = builder.build();
    const auto seams = pair_seams(model, join);
    ASSERT_EQ(seams.size(), 1u);
    EXPECT_NEAR(length_of(model, seams[0].a), 5 * std::numbers::pi, 1e-9);
}

} // namespace
} // namespace keiko
