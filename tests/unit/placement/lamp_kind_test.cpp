#include "keiko/placement/lamp_kind.h"

#include "keiko/math/polygon.h"
#include "keiko/placement/place_lamps.h"
#include "keiko/placement/view_samples.h"
#include "keiko/scene/view.h"

#include "tests/support/analytic_models.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

CPlane slanted_row() {
    CPlane row;
    row.origin = {-500, 200, 1500};
    row.u = {0, 900, 0}, row.v = {1000, 300, 400};
    row.lamps = 5, row.luminance = Rgb(7000, 8000, 9000);
    return row;
}

double area_of(const PolygonLight& light) {
    return polygon_normal(light.corners).length() / 2;
}

TEST(LampKind, TubesAreTheRowItself) {
    const std::vector<LightSource> lights = lights_of(slanted_row(), LampKind::tube, Vec3(0));
    ASSERT_EQ(lights.size(), 1U);
    EXPECT_EQ(std::get<CPlane>(lights[0]).lamps, 5);
}

TEST(LampKind, APanelFillsTheRowAndShinesToTheBody) {
    for (const Vec3& body : {Vec3(0, 0, 0), Vec3(0, 0, 4000)}) {
        const auto lights = lights_of(slanted_row(), LampKind::panel, body);
        ASSERT_EQ(lights.size(), 1U);
        const auto& panel = std::get<PolygonLight>(lights[0]);
        const double width = std::sqrt(1000.0 * 1000 + 400 * 400); // v square to u
        EXPECT_NEAR(area_of(panel), 900 * width, 1e-6);
        EXPECT_TRUE(panel.shines_at(body));
        EXPECT_FALSE(panel.two_sided);
        EXPECT_EQ(panel.luminance, Rgb(7000, 8000, 9000));
    }
}

TEST(LampKind, BarsAreAsWideAsTheGapsAndLieOnTheAxes) {
    const CPlane row = slanted_row();
    const CPlaneFrame frame(row);
    const auto lights = lights_of(row, LampKind::screen, Vec3(0));
    ASSERT_EQ(lights.size(), 5U);
    for (int lamp = 0; lamp < 5; ++lamp) {
        const auto& bar = std::get<PolygonLight>(lights[static_cast<std::size_t>(lamp)]);
        EXPECT_NEAR(area_of(bar), frame.length * frame.pitch / 2, 1e-6);
        Vec3 middle(0);
        for (const Vec3& corner : bar.corners) middle += corner / 4;
        EXPECT_LT((middle - frame.at(frame.length / 2, frame.axis(lamp))).length(), 1e-9);
        EXPECT_TRUE(bar.shines_at(Vec3(0)));
    }
}

/// True if a ray from a place meets the lit side of a panel.
bool meets(const PolygonLight& panel, const Vec3& origin, const Vec3& direction) {
    const Vec3 normal = panel.normal();
    const double t = normal.dot(panel.corners[0] - origin) / normal.dot(direction);
    if (!(t > 0) || !panel.shines_at(origin)) return false;
    const Vec3 place = origin + direction * t;
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec3 edge = panel.corners[(i + 1) % 4] - panel.corners[i];
        if (normal.dot(edge.cross(place - panel.corners[i])) < 0) return false;
    }
    return true;
}

TEST(LampKind, PlacedPanelsAreMirroredByTheShareThatIsTold) {
    const SurfaceModel model = test::bonnet_model(1100, 1400, 60);
    const Tracer tracer(model);
    const Camera camera = frame_view("high-front", tracer.bounds(), {.width = 320, .height = 180});
    PlacementOptions options;
    options.kind = LampKind::panel, options.sampling.samples = 4000;
    const Placement placed = place_lamps(tracer, model, camera, options);
    EXPECT_EQ(placed.kind, LampKind::panel);
    double mirrored = 0, all = 0;
    for (const ViewSample& sample :
         sample_views(tracer, model, std::span(&camera, 1), options.sampling)) {
        all += sample.weight;
        const bool hit = std::any_of(
            placed.rig.sources.begin(), placed.rig.sources.end(), [&](const LightSource& light) {
                return meets(std::get<PolygonLight>(light), sample.mirror.origin,
                             sample.mirror.direction);
            });
        if (hit && !sample.blocked) mirrored += sample.weight;
    }
    EXPECT_GT(placed.coverage, 0.8);
    EXPECT_NEAR(mirrored / all, placed.coverage, 0.02);
}

} // namespace
} // namespace keiko
