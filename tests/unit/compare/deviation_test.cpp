#include "keiko/compare/shape/deviation.h"

#include "tests/support/model_builder.h"
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace keiko {
namespace {

using test::ModelBuilder;

/// A bicubic sheet of 300 x 300 mm, bulging; `change` moves one of its inner control points up.
SurfaceModel sheet(double change = 0) {
    std::vector<Vec3> points;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            points.emplace_back(100 * i, 100 * j, 20 * (i % 3 != 0) + 15 * (j % 3 != 0));
    points[5].z += change;
    ModelBuilder builder;
    builder.patch(3, 3, points);
    return builder.build();
}

Deviation between(const SurfaceModel& body, const SurfaceModel& other, const Job& job = {}) {
    return measure_deviation(ClosestPointQuery(placed_model(body)),
                             ClosestPointQuery(placed_model(other)), {}, job);
}

TEST(Deviation, IsNoneOfABodyToItself) {
    const Deviation none = between(sheet(), sheet());
    EXPECT_LT(none.root_mean_square, 1e-11);
    EXPECT_LT(std::abs(none.worst.value), 1e-10);
    EXPECT_LT(none.worst_normal.value, 1e-9);
    EXPECT_EQ(none.uncertain_share, 0);
    ASSERT_EQ(none.faces.size(), 1u);
    EXPECT_EQ(none.faces[0].turned, 0);
    EXPECT_EQ(none.faces[0].partner, 0u);
    EXPECT_FALSE(none.faces[0].alone());
    EXPECT_EQ(none.beyond, 0);
}

TEST(Deviation, IsTheOffsetOfAParallelPlane) {
    ModelBuilder low, high;
    low.plane({0, 0, 0}, {100, 0, 0}, {0, 100, 0});
    high.plane({10, 10, 0.25}, {50, 0, 0}, {0, 50, 0});
    const Deviation up = between(high.build(), low.build());
    EXPECT_NEAR(up.mean, 0.25, 1e-12);
    EXPECT_NEAR(up.median, 0.25, 1e-12);
    EXPECT_NEAR(up.percent_99_9, 0.25, 1e-12);
    EXPECT_NEAR(up.worst.value, 0.25, 1e-12);
    EXPECT_NEAR(up.area, 2500, 1e-6);
    const Deviation back = between(low.build(), high.build());
    EXPECT_LT(back.worst.value, -0.25); // the rim lies beside the smaller one
    EXPECT_NEAR(std::abs(back.worst.value), std::hypot(40, 40, 0.25), 0.5);
    EXPECT_EQ(back.uncertain_share, 0); // it ends where its patch ends: nothing is trimmed away
}

TEST(Deviation, TheWorstPlaceOfAllIsThatOfItsFace) {
    const Deviation moved = between(sheet(3), sheet());
    EXPECT_GT(moved.worst.value, 0.5);
    EXPECT_EQ(moved.worst.value, moved.faces[moved.worst.face].worst.value);
    EXPECT_EQ(moved.worst.place, moved.faces[moved.worst.face].worst.place);
}

TEST(Deviation, FindsThePeakOfAMovedControlPoint) {
    // The largest B1(u) B1(v) of degree 3 is (4/9)^2, at (1/3, 1/3).
    for (const double change : {1e-3, 1e-2, 1e-1}) {
        const Deviation found = between(sheet(change), sheet());
        const double vertical = change * 16 / 81;
        EXPECT_LE(found.worst.value, vertical * (1 + 1e-6));
        EXPECT_GT(found.worst.value, 0.9 * vertical) << change; // the sheet is a little inclined
        EXPECT_NEAR(found.worst.place.x, 100, 15);
        EXPECT_NEAR(found.worst.place.y, 100, 15);
        EXPECT_GT(found.worst_normal.value, 0);
        EXPECT_EQ(found.uncertain_share, 0);
    }
    EXPECT_LT(between(sheet(-0.01), sheet()).worst.value, 0);
}

TEST(Deviation, NoticesAFaceTurnedInsideOut) {
    SurfaceModel turned = sheet();
    turned.faces[0].reversed = true;
    const Deviation found = between(turned, sheet());
    EXPECT_EQ(found.faces[0].turned, 1);
    EXPECT_LT(found.worst_normal.value, 1e-9);
}

TEST(Deviation, NoticesATrimThatMoved) {
    const auto holed = [](double side) {
        ModelBuilder builder;
        builder.plane({0, 0, 0}, {100, 0, 0}, {0, 100, 0});
        builder.polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
        builder.polygon({{0.4, 0.4}, {0.4, 0.6}, {side, 0.6}, {side, 0.4}});
        return builder.build();
    };
    const Deviation wider = between(holed(0.6001), holed(0.6)); // by 0.01 mm
    EXPECT_NEAR(wider.worst_border.value, 0.01, 1e-9);
    EXPECT_NEAR(wider.worst_border.place.x, 60.01, 1e-9);
    EXPECT_LT(between(holed(0.6), holed(0.6)).worst_border.value, 1e-12);
}

/// Two plates beside each other; the second is left out where `both` is false.
SurfaceModel plates(bool both) {
    ModelBuilder builder;
    builder.plane({0, 0, 0}, {100, 0, 0}, {0, 100, 0});
    if (both) builder.plane({100, 0, 0}, {100, 0, 0}, {0, 100, 0});
    return builder.build();
}

TEST(Deviation, TellsWhatIsFurtherThanTheReachWithoutItsDistance) {
    const Deviation found =
        measure_deviation(ClosestPointQuery(placed_model(plates(true))),
                          ClosestPointQuery(placed_model(plates(false))), {.reach = 20});
    EXPECT_EQ(found.worst.value, std::numeric_limits<double>::infinity());
    EXPECT_NEAR(found.beyond, 0.4, 0.01); // 80 of 200 mm
    EXPECT_LT(found.median, 1e-9);
    EXPECT_EQ(found.percent_99, std::numeric_limits<double>::infinity());
    EXPECT_LE(found.highest, 20);
}

TEST(Deviation, TellsAFaceThatTheOtherDoesNotHave) {
    const Deviation found = between(plates(true), plates(false));
    EXPECT_FALSE(found.faces[0].alone());
    EXPECT_TRUE(found.faces[1].alone());
    EXPECT_EQ(found.faces[1].partner, 0u); // what of it is nearest
}

TEST(Deviation, EndsSoonForBodiesThatAreFarApart) {
    ModelBuilder far;
    far.plane({1e5, 0, 0}, {100, 0, 0}, {0, 100, 0});
    const Deviation found =
        measure_deviation(ClosestPointQuery(placed_model(sheet())),
                          ClosestPointQuery(placed_model(far.build())), {.reach = 20});
    EXPECT_EQ(found.beyond, 1);
    EXPECT_EQ(found.faces[0].partner, no_index);
    EXPECT_EQ(found.worst_border.value, std::numeric_limits<double>::infinity());
}

TEST(Deviation, IsTheSameForAnyNumberOfThreads) {
    const Deviation one = between(sheet(0.1), sheet(), {.threads = 1});
    const Deviation two = between(sheet(0.1), sheet(), {.threads = 2});
    EXPECT_EQ(one.mean, two.mean);
    EXPECT_EQ(one.root_mean_square, two.root_mean_square);
    EXPECT_EQ(one.worst.value, two.worst.value);
    EXPECT_EQ(one.worst.place, two.worst.place);
}

} // namespace
} // namespace keiko
