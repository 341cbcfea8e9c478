#include "keiko/drawing/hidden/piercings.h"

#include "tests/support/squares.h"
#include <gtest/gtest.h>

#include <cmath>

namespace keiko {
namespace {

TEST(Piercings, AtAPointOfTheCurveCountOnce) {
    const SurfaceModel model = test::squares(0, 0, 0);
    const Tracer tracer(model);
    ModelCurve curve;
    for (const double z : {-2.0, -1.0, 0.0, 1.0, 2.0})
        curve.course.points.push_back(Vec3(5 + z / 4, 1, z)); // through the second square
    const auto found = find_piercings({curve}, tracer);
    ASSERT_EQ(found[0].piercings.size(), 1u);
    EXPECT_NEAR(found[0].piercings[0].t, 2, 1e-9);
    EXPECT_NEAR(std::abs(found[0].piercings[0].normal.z), 1, 1e-9);
}

/// Piercings of the second square by a segment that ends `depth` below it, and `way` along it
/// behind the place where it pierces. It may lie `reach` beside its own faces.
std::size_t piercings_before_end(double depth, double way, double reach) {
    const SurfaceModel model = test::squares(0, 0, 0);
    const Tracer tracer(model);
    const Vec3 place(5, 1, 0), end = place + Vec3(way, 0, -depth);
    ModelCurve curve;
    curve.reach = reach;
    curve.course.points = {place + (place - end) * (2 / way), end};
    return find_piercings({curve}, tracer)[0].piercings.size();
}

TEST(Piercings, WithinTheGapOfASeamAreNoneNearAnEnd) {
    constexpr double reach = 0.002, way = 0.1;
    EXPECT_EQ(piercings_before_end(0.9 * reach, way, reach), 0u);
    EXPECT_EQ(piercings_before_end(1.1 * reach, way, reach), 1u);
    EXPECT_EQ(piercings_before_end(0.9 * reach, way, 0.1 * reach), 1u);
    EXPECT_EQ(piercings_before_end(0.9 * reach, 3 * way, reach), 1u);
}

} // namespace
} // namespace keiko
