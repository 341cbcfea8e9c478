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

} // namespace
} // namespace keiko
