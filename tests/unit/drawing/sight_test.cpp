#include "keiko/drawing/hidden/sight_test.h"

#include "tests/support/drawn_body.h"
#include "tests/support/squares.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

/// Sheets before a point that many gaps below the seam of two squares, seen from above. The
/// squares are scaled, and lengths with them.
int sheets_above(double gaps, double scale) {
    constexpr double gap = 0.03;
    SurfaceModel model = test::squares(gap, 2 * gap, 0);
    model.instances[0].transform = Affine::scale(scale);
    const Tracer tracer(model);
    const ImageProjection projection(
        test::camera_along(Projection::orthographic, {0, 0, 100}, {0, 0, -1}, {0, 1, 0}));
    const Vec3 point = Vec3(0.002, 1.3, -gaps * gap) * scale;
    ModelCurve curve;
    curve.course.points = {point, point + Vec3(0, scale, 0)};
    return SightTest(model, tracer, projection).sheets_before(point, curve);
}

TEST(SightTest, GapsOfSeamsAreAsWideAsTheirInstanceMakesThem) {
    for (const double scale : {0.1, 1.0, 10.0}) {
        EXPECT_EQ(sheets_above(3, scale), 0) << scale; // within twice the seam's width
        EXPECT_EQ(sheets_above(6, scale), 1) << scale;
    }
}

} // namespace
} // namespace keiko
