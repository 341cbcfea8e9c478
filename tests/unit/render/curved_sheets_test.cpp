// Luminous sheets with singular corners, trims and creases, held against rays.
#include "keiko/visibility/contours/body_contour.h"

#include "tests/support/random.h"
#include "tests/support/shapes.h"
#include "tests/unit/render/luminous_sheets.h"

#include <array>
#include <cstdlib>

namespace keiko {
namespace {

/// A curved sheet of one bicubic patch, across 400 mm in x and y.
test::PatchData sheet() {
    test::PatchData patch{3, 3, {}, {}, {}};
    for (int i = 0; i <= 3; ++i)
        for (int j = 0; j <= 3; ++j) {
            const double x = 400 * (i / 3.0 - 0.5), y = 400 * (j / 3.0 - 0.5);
            patch.points.emplace_back(x, y, 600 + (x * x + 0.4 * y * y - x * y) / 300, 1);
        }
    return patch;
}

/// Sheets that all planes through a point enter less those that they leave, added up: 0 of outlines
/// without gaps.
int sheets_left_over(const SurfaceModel& model, const Vec3& point) {
    const ContourArcs arcs = BodyContour(model).arcs_from(point, 1e-6);
    EXPECT_TRUE(arcs.are_complete);
    test::Random random(5);
    int off = 0;
    for (int i = 0; i < 100; ++i) {
        const Vec3 plane = test::random_direction(random);
        SheetCount sum;
        for (const ContourArc& arc : arcs.all)
            for (const ArcRoot& root : arc.crossings(plane))
                sum += arc.left * (root.rises ? 1 : -1);
        off += std::abs(sum.front) + std::abs(sum.back);
    }
    return off;
}

/// A corner is round where its sides go on in one direction: no cross product is a normal there.
TEST(CurvedSheets, CornerWithoutANormalHasBorders) {
    test::PatchData patch = sheet();
    const Vec4 step(70, -75, 30, 0);
    patch.points[4] = patch.points[0] + step;
    patch.points[1] = patch.points[0] - step;
    test::ShapeBuilder builder;
    builder.face({patch});
    const std::array<Vec3, 5> points{Vec3(30, 40, 0), Vec3(100, 0, 1200), Vec3(900, -300, 650),
                                     Vec3(-400, -500, 480), Vec3(-210, -180, 590)};
    test::expect_light_of_rays(builder.model(), points);
    for (const Vec3& point : points)
        EXPECT_EQ(sheets_left_over(builder.model(), point), 0) << point;
}

} // namespace
} // namespace keiko
