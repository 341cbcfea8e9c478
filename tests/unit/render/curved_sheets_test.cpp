// Luminous sheets with singular corners, trims and creases, held against rays.
#include "keiko/geometry/trim/material_bounds.h"
#include "keiko/import/worker/load_model.h"
#include "keiko/visibility/contours/body_contour.h"

#include "tests/support/paths.h"
#include "tests/support/random.h"
#include "tests/support/shapes.h"
#include "tests/unit/render/luminous_sheets.h"

#include <array>
#include <cstdlib>
#include <utility>
#include <vector>

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

/// A curved plate with a hole, at whose rim silhouettes end; from one place it is seen nearly
/// edge-on.
TEST(CurvedSheets, TrimmedPatchShinesAsRaysFind) {
    const SurfaceModel model = load_model(test::repository("surfaces/trimmed-hole.step"));
    const Box3 box = material_bounds(model);
    std::vector<Vec3> points;
    for (const Vec3& away : {Vec3(0.1, 0.2, -1), Vec3(0.1, 0, 1.2), Vec3(1.1, -0.3, 0.02),
                             Vec3(-0.8, 0.9, 0.3), Vec3(-0.2, -1, 0.1)})
        points.push_back(box.center() + away * box.size());
    test::expect_light_of_rays(model, points);
}

/// Two cones rim to rim are one face, without an arc along the rim.
SurfaceModel spindle(std::size_t quarters) {
    std::vector<test::PatchData> patches, cylinder = test::cylinder(150, 200);
    cylinder.resize(quarters);
    for (const bool upper : {false, true})
        for (test::PatchData patch : cylinder) {
            for (std::size_t i = 0; i < patch.points.size(); ++i) {
                Vec4& p = patch.points[i];
                if ((i % 2 == 1) == upper) p.x = p.y = 0;
                p.z += (upper ? 700 : 500) * p.w;
            }
            patch.map_v = {ParameterMap::Kind::affine, upper ? 1.0 : 0.0, upper ? 2.0 : 1.0};
            patches.push_back(std::move(patch));
        }
    test::ShapeBuilder builder;
    builder.face(patches);
    return builder.model();
}

TEST(CurvedSheets, RidgesInsideAFaceAreKnown) {
    EXPECT_FALSE(TracedLamp(spindle(3), {}, LampSides::outer_side).has_known_outlines());
    const SurfaceModel closed = spindle(4);
    const TracedLamp body(closed);
    EXPECT_FALSE(body.has_known_outlines());
    EXPECT_TRUE(body.is_closed());
    const ContourLight light = test::lamp_of(closed, LampSides::of_solid);
    for (const Vec3& point : {Vec3(30, 40, 0), Vec3(300, 0, 1200), Vec3(500, -300, 650)})
        for (const Vec3& normal : {Vec3(0, 0, 1), Vec3(-0.36, 0.48, -0.8)})
            EXPECT_NEAR(projected_solid_angle(light, point, normal),
                        test::by_rays(closed, false, point, normal), 4e-3)
                << point << normal;
}

} // namespace
} // namespace keiko
