#include "keiko/compare/alignment/alignment.h"

#include "keiko/base/error.h"
#include "keiko/base/units.h"

#include "tests/support/model_builder.h"
#include "tests/unit/compare/uneven_sheet.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

using test::ModelBuilder;

SurfaceModel flat() {
    ModelBuilder builder;
    builder.plane({0, 0, 0}, {300, 0, 0}, {0, 200, 0});
    return builder.build();
}

Affine about_middle(const Vec3& axis, double degrees, const Vec3& shift) {
    const Vec3 middle(150, 100, 20);
    return Affine::translate(middle + shift) * Affine::rotate(axis, degrees_to_radians(degrees)) *
           Affine::translate(-middle);
}

/// mm that the copy, moved and brought back, is off at the corners of the sheet.
double left_over(const SurfaceModel& model, const Affine& motion, const Job& job = {}) {
    const Alignment found = align_bodies(ClosestPointQuery(placed_model(model, motion)),
                                         ClosestPointQuery(placed_model(model)), {}, job);
    EXPECT_TRUE(found.converged);
    const Affine both = found.motion * motion;
    double worst = 0;
    for (const Vec3& p : {Vec3(0, 0, 0), Vec3(300, 0, 30), Vec3(0, 200, 60), Vec3(300, 200, 90)})
        worst = std::max(worst, (both.point(p) - p).length());
    return worst;
}

TEST(Alignment, RecoversASmallMotionOfACopy) {
    EXPECT_LT(left_over(test::uneven_sheet(), about_middle({1, 2, 3}, 0.7, {3, -2, 1.5})), 1e-6);
    EXPECT_LT(left_over(test::uneven_sheet(), {}), 1e-6);
}

TEST(Alignment, RecoversALargeMotionOfACopy) {
    EXPECT_LT(left_over(test::uneven_sheet(), about_middle({-1, 0.3, 0.2}, 100, {2000, -700, 90})),
              1e-6);
    EXPECT_LT(left_over(test::uneven_sheet(), about_middle({0, 0, 1}, 180, {0, 0, 500})), 1e-6);
}

TEST(Alignment, LetsBordersSettleWhatAPlaneLeavesFree) {
    EXPECT_LT(left_over(flat(), about_middle({0, 0, 1}, 1.5, {3, -2, 0.5})), 1e-6);
}

TEST(Alignment, RecoversTheMotionOfAStripThatTheFirstPlacesMiss) {
    const SurfaceModel strip = test::uneven_sheet(0.5015, 0.5025); // 0.2 mm wide
    EXPECT_LT(left_over(strip, about_middle({1, 2, 3}, 0.7, {3, -2, 1.5})), 1e-6);
}

TEST(Alignment, RefusesABodyOfWhichNoPlaceIsFound) {
    const ClosestPointQuery hair(placed_model(test::uneven_sheet(0.5025, 0.5025 + 1e-9)));
    const ClosestPointQuery whole(placed_model(test::uneven_sheet()));
    EXPECT_THROW(align_bodies(hair, whole), FieldError);
    EXPECT_THROW(align_bodies(whole, hair), FieldError);
}

TEST(Alignment, TellsTheMotionInWords) {
    const Affine motion = about_middle({0, 0, 1}, 2, {5, 0, 0});
    const Alignment found =
        align_bodies(ClosestPointQuery(placed_model(test::uneven_sheet(), motion)),
                     ClosestPointQuery(placed_model(test::uneven_sheet())));
    EXPECT_NEAR(found.angle, 2, 1e-8);
    EXPECT_NEAR(found.axis.z, -1, 1e-9); // it turns back
    EXPECT_LT(found.residual, 1e-9);
}

TEST(Alignment, IsTheSameForAnyNumberOfThreads) {
    const ClosestPointQuery moved(
        placed_model(test::uneven_sheet(), about_middle({1, 0, 0}, 3, {1, 2, 3})));
    const ClosestPointQuery still(placed_model(test::uneven_sheet()));
    EXPECT_EQ(align_bodies(moved, still, {}, {.threads = 1}).motion,
              align_bodies(moved, still, {}, {.threads = 3}).motion);
}

} // namespace
} // namespace keiko
