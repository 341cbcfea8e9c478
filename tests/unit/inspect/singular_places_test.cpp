// Faces that fold back or have kinks at single places, against faces that are regular.
#include "keiko/inspect/regularity/singular_places.h"

#include "keiko/inspect/inspection.h"

#include "tests/support/model_builder.h"
#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

constexpr int sheets = 12;

/// A bicubic sheet of `size` mm, crowned, whose control point (1, 1) lies at `moved`.
SurfaceModel sheet(double size, const Vec3& moved, double crown = 0) {
    test::ModelBuilder builder;
    std::vector<Vec3> points;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            const bool inner = i % 3 != 0 && j % 3 != 0;
            points.emplace_back(size * i / 3, size * j / 3, inner ? crown : 0);
            if (i == 1 && j == 1) points.back() = moved;
        }
    builder.patch(3, 3, points);
    return builder.build();
}

/// Sheet x = a (2 t)^3 / 2 + b (y - y0)^2 t, z = h (2 t)^2 with t = u - 1/2. At y0 the speed across
/// is 0 at a single place, where the section is a cusp.
SurfaceModel cusp(double a, double b, double share, double h) {
    test::ModelBuilder builder;
    const double cube[] = {-a / 2, a / 2, -a / 2, a / 2}, line[] = {-0.5, -1.0 / 6, 1.0 / 6, 0.5};
    const double square[] = {h, -h / 3, -h / 3, h};
    // (v - share)^2 in Bernstein form
    const double along[] = {share * share, share * share - share, (1 - share) * (1 - share)};
    std::vector<Vec3> points;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 3; ++j)
            points.emplace_back(cube[i] + b * along[j] * line[i], 50.0 * j, square[i]);
    builder.patch(3, 2, points);
    return builder.build();
}

std::vector<SingularPlace> places_of(const SurfaceModel& model) {
    return singular_places(model, 0, 0, {});
}

bool has(const std::vector<SingularPlace>& places, SingularPlace::Kind kind) {
    return std::any_of(places.begin(), places.end(),
                       [kind](const SingularPlace& place) { return place.kind == kind; });
}

TEST(SingularPlaces, FoldsWithinAFaceFail) {
    test::Random random(1);
    for (int i = 0; i < sheets; ++i) {
        const double size = test::uniform(random, 20, 500);
        const double back = -size * test::uniform(random, 0.5, 1);
        const Inspection inspection = inspect(sheet(size, {back, back, 0}));
        EXPECT_EQ(inspection.verdict, Verdict::fail) << size << " " << back;
        ASSERT_FALSE(inspection.findings.empty());
        EXPECT_EQ(inspection.findings.front().code, "G-SU-FO");
        EXPECT_NEAR(inspection.findings.front().worst.value, 180, 5);
        EXPECT_EQ(inspection.face_counts.fail, 1u);
    }
}

/// A flat sheet `width` mm wide whose parameter u turns back at `share`, and runs askew.
SurfaceModel oblique_fold(double share, double width) {
    // x = c (u - share)^2 in Bernstein form of degree 3, y = 30 u + width v
    const double c = 266,
                 square[] = {share * share, share * share - 2 * share / 3,
                             share * share - 4 * share / 3 + 1.0 / 3, (1 - share) * (1 - share)};
    std::vector<Vec3> points;
    for (int i = 0; i < 4; ++i)
        for (const double y : {0.0, width}) points.emplace_back(c * square[i], 10 * i + y, 0);
    test::ModelBuilder builder;
    builder.patch(3, 1, points);
    return builder.build();
}

TEST(SingularPlaces, FoldsThatRunAskewFailWhereverTheyLie) {
    for (const double share : {0.5, 0.25, 0.75, 0.47, 0.49})
        for (const double width : {100.0, 200.0, 500.0, 3000.0}) {
            const SurfaceModel model = oblique_fold(share, width);
            EXPECT_TRUE(has(places_of(model), SingularPlace::Kind::fold)) << share << " " << width;
            EXPECT_EQ(inspect(model).verdict, Verdict::fail);
        }
    // Along the very lines at which parts are cut no part of it is found.
    EXPECT_NE(inspect(oblique_fold(0.4811, 500)).verdict, Verdict::pass);
}

TEST(SingularPlaces, NotShownToBeRegularIsUndecided) {
    const SurfaceModel model = oblique_fold(0.5, 500);
    const auto places = singular_places(model, 0, 0, {}, 3);
    ASSERT_EQ(places.size(), 1u);
    EXPECT_EQ(places[0].kind, SingularPlace::Kind::unresolved);
    EXPECT_EQ(verdict_of(places[0].kind), Verdict::undecided);
}

TEST(SingularPlaces, FoldsOfBilinearFacesFail) {
    for (const Vec3& last : {Vec3(20, 20, 0), Vec3(5, 10, 0)}) {
        test::ModelBuilder builder;
        builder.patch(1, 1, {{0, 0, 0}, {0, 50, 0}, {50, 0, 0}, last});
        EXPECT_TRUE(has(places_of(builder.build()), SingularPlace::Kind::fold));
    }
}

TEST(SingularPlaces, TrimmedOffAreNone) {
    test::ModelBuilder builder;
    builder.patch(1, 1, {{0, 0, 0}, {0, 50, 0}, {50, 0, 0}, {20, 20, 0}});
    builder.polygon({{0, 0}, {0.3, 0}, {0.3, 0.3}, {0, 0.3}});
    EXPECT_TRUE(places_of(builder.build()).empty());
}

TEST(SingularPlaces, AreFoundWhereTheSpeedVanishesAtOnePlace) {
    test::Random random(2);
    for (int i = 0; i < sheets; ++i) {
        const double share = test::uniform(random, 0.1, 0.9);
        const SurfaceModel model =
            cusp(test::uniform(random, 50, 200), test::uniform(random, 50, 200), share,
                 test::uniform(random, 0.05, 1));
        const auto places = places_of(model);
        ASSERT_TRUE(has(places, SingularPlace::Kind::no_limit)) << share;
        EXPECT_NEAR(places.front().place.y, 100 * share, 0.3);
        EXPECT_NEAR(places.front().place.x, 0, 0.3);
        EXPECT_FALSE(has(places, SingularPlace::Kind::fold));
    }
}

TEST(SingularPlaces, RegularSheetsHaveNone) {
    test::Random random(3);
    for (int i = 0; i < sheets; ++i) {
        const double size = test::uniform(random, 20, 500);
        const Vec3 moved = Vec3(1, 1, 0) * (size * test::uniform(random, 0.1, 0.5));
        EXPECT_TRUE(places_of(sheet(size, moved, test::uniform(random, -1, 1) * size)).empty());
    }
}

TEST(SingularPlaces, PolesAndTipsHaveNone) {
    // An eighth of a sphere, and a cone: quarter circles about z, with one side that is a point.
    const double w = std::sqrt(0.5);
    const Vec2 circle[] = {{1, 0}, {1, 1}, {0, 1}};
    const double weights[] = {1, w, 1};
    test::ModelBuilder sphere;
    std::vector<Vec4> ball, cone;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const double weight = weights[i] * weights[j], r = 50 * circle[i].x;
            ball.emplace_back(weight * r * circle[j].x, weight * r * circle[j].y,
                              weight * 50 * circle[i].y, weight);
        }
    sphere.rational_patch(2, 2, ball);
    EXPECT_TRUE(places_of(sphere.build()).empty());
    for (const double radius : {5.0, 50.0, 500.0}) {
        test::ModelBuilder tip;
        cone.clear();
        for (const double share : {0.0, 1.0})
            for (int j = 0; j < 3; ++j)
                cone.emplace_back(weights[j] * share * radius * circle[j].x,
                                  weights[j] * share * radius * circle[j].y,
                                  weights[j] * (1 - share) * 50, weights[j]);
        tip.rational_patch(1, 2, cone);
        EXPECT_TRUE(places_of(tip.build()).empty()) << radius;
    }
}

TEST(SingularPlaces, TipsWhoseBordersCrossHaveNone) {
    // Two borders that run into one point, and beyond it by a few nanometres to micrometres.
    test::Random random(4);
    for (int i = 0; i < sheets; ++i) {
        const double beyond = std::pow(10, test::uniform(random, -6, -2.5));
        const double wide = test::uniform(random, 1, 20), long_ = test::uniform(random, 5, 500);
        test::ModelBuilder builder;
        builder.patch(1, 1, {{beyond, 0, 0}, {-wide, long_, 0}, {-beyond, 0, 0}, {wide, long_, 0}});
        const auto places = places_of(builder.build());
        EXPECT_FALSE(has(places, SingularPlace::Kind::fold))
            << beyond << " " << wide << " " << long_;
        // What is turned over for less than the negligible length is not listed.
        EXPECT_TRUE(beyond / wide * long_ > 0.1 || places.empty());
    }
}

TEST(SingularPlaces, SidesThatTheSpeedVanishesAlongHaveNone) {
    // x = 100 u^2: the same plane as with x = 100 u.
    test::ModelBuilder builder;
    builder.patch(2, 1, {{0, 0, 0}, {0, 50, 0}, {0, 0, 0}, {0, 50, 0}, {100, 0, 0}, {100, 50, 0}});
    EXPECT_TRUE(places_of(builder.build()).empty());
}

TEST(SingularPlaces, VeryUnequalWeightsAreUndecided) {
    for (const double ratio : {1e3, 1e5, 1e7}) {
        test::ModelBuilder builder;
        builder.rational_patch(1, 1,
                               {{0, 0, 0, 1},
                                Vec4(0, 100, 0, 1) * ratio,
                                {100, 0, 0, 1},
                                Vec4(100, 100, 0, 1) * ratio});
        EXPECT_EQ(has(places_of(builder.build()), SingularPlace::Kind::uneven), ratio > 1e4);
        const Verdict verdict = inspect(builder.build()).verdict;
        EXPECT_EQ(verdict, ratio > 1e4 ? Verdict::undecided : Verdict::pass);
    }
}

} // namespace
} // namespace keiko
