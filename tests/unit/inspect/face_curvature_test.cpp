#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/inspect/basics/patch_box.h"
#include "keiko/inspect/curvature/curvature_range.h"
#include "keiko/inspect/curvature/face_measure.h"

#include "tests/support/analytic_models.h"
#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

using test::ModelBuilder;

FaceCurvature curvature_of(const SurfaceModel& model, std::size_t most_splits = 100) {
    const auto curvature = face_curvature(model, 0, 0, most_splits);
    EXPECT_TRUE(curvature.has_value());
    return curvature.value_or(FaceCurvature{});
}

/// `share` of the larger of the curvature and 1 / size.
void expect_extreme(const CurvatureExtreme& extreme, double exact, double size,
                    double share = 1e-9) {
    const double unit = std::max(std::abs(exact), 1 / size);
    EXPECT_NEAR(extreme.value, exact, share * unit);
    EXPECT_LE(extreme.bound, curvature_tolerance * unit);
    EXPECT_FALSE(extreme.undecided);
}

TEST(FaceCurvature, IsThatOfASphereEverywhere) {
    for (const double radius : {0.5, 80.0, 2500.0}) {
        const FaceCurvature c = curvature_of(
            test::sphere_model(test::stretched(Vec3(radius), {1, 2, 3}, Vec3(4000, -900, 1200))));
        EXPECT_GT(c.singular, 0); // at its poles
        for (const CurvatureExtreme* k :
             {&c.largest, &c.smallest, &c.largest_mean, &c.smallest_mean})
            EXPECT_NEAR(k->value, -1 / radius, 1e-9 / radius);
        EXPECT_NEAR(c.largest_gaussian.value, 1 / (radius * radius), 2e-9 / (radius * radius));
    }
}

TEST(FaceCurvature, IsThatOfACylinder) {
    const double radius = 40;
    const FaceCurvature c = curvature_of(
        test::cylinder_model(test::stretched({radius, radius, 100}, {0, 0, 1}, Vec3(0))));
    EXPECT_EQ(c.singular, 0);
    expect_extreme(c.smallest, -1 / radius, 200);
    expect_extreme(c.largest, 0, 200);
    expect_extreme(c.largest_mean, -0.5 / radius, 200);
    expect_extreme(c.smallest_mean, -0.5 / radius, 200);
    EXPECT_NEAR(c.largest_gaussian.value, 0, 1e-12);
}

/// A ring of radius 100 whose tube has radius 30: exact, rational.
SurfaceModel torus() {
    const double s = std::numbers::sqrt2 / 2, ring = 100, tube = 30;
    std::vector<Vec4> profile;
    const Vec3 circle[9] = {{1, 0, 1},   {s, s, s},  {0, 1, 1},  {-s, s, s}, {-1, 0, 1},
                            {-s, -s, s}, {0, -1, 1}, {s, -s, s}, {1, 0, 1}};
    for (const Vec3& c : circle) profile.emplace_back(ring * c.z + tube * c.x, 0, tube * c.y, c.z);
    ModelBuilder builder;
    builder.nurbs(test::revolution(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}, profile));
    return builder.build();
}

TEST(FaceCurvature, FindsTheExtremesOfATorus) {
    const FaceCurvature c = curvature_of(torus());
    EXPECT_NEAR(c.smallest.value, -1 / 30.0, 1e-9 / 30);
    EXPECT_NEAR(c.largest.value, 1 / 70.0, 1e-9 / 70); // inside the ring
    EXPECT_NEAR(std::hypot(c.largest.place.x, c.largest.place.y), 70, 0.1);
    EXPECT_NEAR(c.smallest_mean.value, -(1 / 30.0 + 1 / 130.0) / 2, 1e-9 / 30);
    EXPECT_NEAR(c.smallest_gaussian.value, -1 / (30.0 * 70), 1e-9);
    EXPECT_NEAR(c.largest_gaussian.value, 1 / (30.0 * 130), 1e-9);
}

// It is as bent everywhere: all of it must be cut to small pieces.
TEST(FaceCurvature, BoundsATorusWithinItsBudget) {
    const FaceCurvature c = *face_curvature(torus(), 0, 0);
    const double size = 300;
    expect_extreme(c.largest, 1 / 70.0, size);
    expect_extreme(c.smallest, -1 / 30.0, size);
    expect_extreme(c.largest_mean, -(1 / 30.0 - 1 / 70.0) / 2, size);
    expect_extreme(c.smallest_mean, -(1 / 30.0 + 1 / 130.0) / 2, size);
    for (const CurvatureExtreme* k : {&c.largest_gaussian, &c.smallest_gaussian})
        EXPECT_LE(k->bound, curvature_tolerance * std::abs(k->value));
}

TEST(FaceCurvature, SaysWhereItsBoundsStayWide) {
    // A torus is as bent everywhere, so that no piece of it can be set aside.
    const FaceCurvature coarse = curvature_of(torus(), 10), fine = curvature_of(torus(), 300);
    EXPECT_TRUE(coarse.smallest.undecided);
    EXPECT_GT(coarse.smallest.bound, curvature_tolerance / 30);
    EXPECT_LT(fine.smallest.bound, coarse.smallest.bound / 10);
}

TEST(FaceCurvature, FindsThePeakOfASaddleWithinASideOfItsDomain) {
    // z = x y / r has its largest Gaussian curvature -1 / r^2 at the origin, off the middle here.
    const double r = 200;
    ModelBuilder builder;
    const auto at = [&](double x, double y) { return Vec3(x, y, x * y / r); };
    builder.patch(1, 1, {at(-70, -90), at(-70, 110), at(130, -90), at(130, 110)});
    const FaceCurvature c = curvature_of(builder.build(), 600);
    expect_extreme(c.largest, 1 / r, 290, curvature_tolerance);
    EXPECT_LE(std::abs(c.largest.value), 1 / r + 1e-12);
    EXPECT_LT(c.largest.place.length(), 15);
    EXPECT_NEAR(c.smallest_gaussian.value, -1 / (r * r), curvature_tolerance / (r * r));
}

TEST(FaceCurvature, LooksOnlyAtWhatTrimsLeave) {
    // A parabola's sharpest place x = 0 is cut away: from x = 30 on it is flatter.
    const double bend = 1 / 50.0; // z = x^2 bend / 2
    ModelBuilder builder;
    std::vector<Vec3> points;
    for (const auto& [x, z] : {std::pair{-100.0, 100.0}, {0.0, -100.0}, {100.0, 100.0}})
        for (const double y : {0.0, 50.0}) points.emplace_back(x, y, z);
    builder.patch(2, 1, points);
    const FaceCurvature whole = curvature_of(builder.build());
    EXPECT_NEAR(whole.largest.value, bend, 1e-12);
    builder.polygon({{0.65, 0.1}, {0.9, 0.1}, {0.9, 0.9}, {0.65, 0.9}});
    const FaceCurvature cut = curvature_of(builder.build());
    const double exact = bend / std::pow(1 + std::pow(30 * bend, 2), 1.5);
    EXPECT_LE(cut.largest.value, exact * (1 + 1e-12));
    EXPECT_GE(cut.largest.value + cut.largest.bound, exact * (1 - 1e-12));
    EXPECT_LT(cut.largest.bound, 0.05 * exact);
    EXPECT_NEAR(cut.largest.place.x, 30, 2);
}

TEST(FaceCurvature, TurnsItsSignWithTheOutwardNormal) {
    SurfaceModel model = test::cylinder_model(Affine::scale(10));
    model.faces[0].reversed = true;
    EXPECT_NEAR(curvature_of(model).largest.value, 0.1, 1e-10);
    model.faces[0].reversed = false;
    EXPECT_NEAR(curvature_of(model).smallest.value, -0.1, 1e-10);
    Affine mirror = Affine::scale(10);
    mirror.rows[0].x = -10;
    model.instances[0].transform = mirror; // what is convex stays so
    EXPECT_NEAR(curvature_of(model).smallest.value, -0.1, 1e-10);
    EXPECT_NEAR(curvature_of(model).largest.value, 0, 1e-10);
}

TEST(CurvatureRange, HoldsTheCurvaturesOfEveryPlaceOfAPiece) {
    test::Random random(5);
    for (int trial = 0; trial < 40; ++trial) {
        const bool rational = trial % 2 == 0;
        std::vector<Vec4> points;
        for (int i = 0; i <= 3; ++i)
            for (int j = 0; j <= 3; ++j) {
                const double w = rational ? test::uniform(random, 0.7, 1.4) : 1;
                const Vec3 p(30 * i + test::uniform(random, -4, 4),
                             30 * j + test::uniform(random, -4, 4), test::uniform(random, -3, 3));
                points.emplace_back(p.x * w, p.y * w, p.z * w, w);
            }
        PatchBox piece({3, 3, points});
        for (int cut = 0; cut < 6; ++cut) piece = piece.halves(cut % 2 == 0)[test::pick(random, 2)];
        const CurvatureRange range = curvature_range(piece.view());
        EXPECT_TRUE(range.finite());
        for (int sample = 0; sample < 50; ++sample) {
            const Vec2 uv(test::uniform(random, 0, 1), test::uniform(random, 0, 1));
            const SurfaceDerivatives s = evaluate(piece.view(), uv, 2);
            const PrincipalCurvatures k =
                principal_curvatures(s, s.du().cross(s.dv()).normalized());
            const auto holds = [](const Interval& i, double value) {
                return i.low <= value + 1e-12 && value - 1e-12 <= i.high;
            };
            EXPECT_TRUE(holds(range.k1.range, k.k1) && holds(range.k2.range, k.k2));
            EXPECT_TRUE(holds(range.mean.range, k.mean()));
            EXPECT_TRUE(holds(range.gaussian.range, k.gaussian()));
        }
    }
}

} // namespace
} // namespace keiko
