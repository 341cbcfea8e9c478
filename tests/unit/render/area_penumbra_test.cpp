#include "keiko/light/areas/area_penumbra.h"

#include "keiko/light/areas/area_irradiance.h"
#include "keiko/math/polygon.h"
#include "keiko/render/shading/occluded_visibility.h"

#include "tests/support/curved_row.h"
#include "tests/support/oracle.h"
#include "tests/support/polyhedron_row.h"
#include "tests/support/shapes.h"
#include "tests/unit/render/plates.h"
#include <gtest/gtest.h>

#include <cmath>

namespace keiko {
namespace {

using namespace test;

/// Expects a light's error to stay below `allowed` of it without plates.
void compare(const OracleRow& row, double lx, double allowed) {
    EXPECT_NEAR(lx, row.number("out.E"), allowed * row.number("out.E_unocc") + 1e-9)
        << row.id() << ' ' << row.text("note") << ", of " << row.number("out.E_unocc");
}

TEST(AreaPenumbra, PolygonBehindPlatesMeetsTheOracle) {
    const OracleTable table("area_polygon_occluded");
    ASSERT_GE(table.size(), 20U);
    for (const OracleRow& row : table) {
        const Plates plates(row);
        const PolygonLight light{row.points("in.V"), Rgb(1), true};
        const double luminance = row.number("in.L");
        compare(row, luminance * plates.seen(light, of_numbers), 1e-4);
        compare(row, luminance * plates.seen(light, {1e-7, 0.12, true}), 1e-6);
    }
}

TEST(AreaPenumbra, SphereBehindPlatesMeetsTheOracle) {
    const OracleTable table("area_sphere");
    ASSERT_GE(table.size(), 12U);
    for (const OracleRow& row : table) {
        const Plates plates(row);
        const SphereLight light{row.vector("in.C"), row.number("in.R"), Rgb(1)};
        const double luminance = row.number("in.L");
        compare(row, luminance * plates.seen(light, of_numbers), 1e-4);
        compare(row, luminance * plates.seen(light, {1e-7, 0.12, true}), 1e-6);
    }
}

TEST(AreaPenumbra, CurvedBodyBehindPlatesMeetsTheOracle) {
    const OracleTable table("area_curved");
    ASSERT_GE(table.size(), 13U);
    for (const OracleRow& row : table) {
        const Plates plates(row);
        const auto lx = [&](const WidthOptions& options) {
            double sum = 0;
            for (const auto& part : parts_of(row))
                sum += std::visit([&](const auto& light) { return plates.seen(light, options); },
                                  part);
            return sum * row.number("in.L");
        };
        compare(row, lx(of_numbers), 1e-4);
        compare(row, lx({1e-7, 0.12, true}), 1e-6);
    }
}

TEST(AreaPenumbra, PolyhedronBehindPlatesMeetsTheOracle) {
    for (const OracleRow& row : OracleTable("area_polyhedron")) {
        const Plates plates(row);
        double lx = 0;
        for (const PolygonLight& face : faces_of(row))
            lx += face.luminance.r * plates.seen(face, of_numbers);
        compare(row, lx, 1e-4);
    }
}

/// A rectangle above the origin, parallel to the ground.
std::vector<Vec3> level_rectangle(double half_x, double half_y, double z) {
    return {{-half_x, -half_y, z}, {half_x, -half_y, z}, {half_x, half_y, z}, {-half_x, half_y, z}};
}

double seen_share(const PolygonLight& light, const SurfaceModel& model,
                  const WidthOptions& options) {
    const Tracer tracer(model);
    const Occluders occluders(model, tracer);
    const OccludedVisibility visible(&occluders, tracer, Viewpoint::at(Vec3(0)), bounds_of(light),
                                     {}, Vec3(0, 0, 1));
    return visible_share(light, Vec3(0), {0, 0, 1}, visible, options);
}

TEST(AreaPenumbra, ACeilingHidesNothingOfAPanelThatIsFlushWithIt) {
    ShapeBuilder shapes;
    add_plate(level_rectangle(3000, 3000, 3000), shapes);
    const PolygonLight light{level_rectangle(1000, 1000, 3000), Rgb(1), true};
    EXPECT_EQ(seen_share(light, shapes.model(), of_numbers), 1);
    EXPECT_EQ(seen_share(light, shapes.model(), {3e-3, 1, true}), 1);
}

/// A bar of 300 mm halfway to a panel of 4 m hides the strip of 600 mm, along or across the lines.
TEST(AreaPenumbra, ABarIsFoundWithTheAccuracyOfPictures) {
    const PolygonLight light{level_rectangle(2000, 2000, 3000), Rgb(1), true};
    const double whole = projected_solid_angle(light, Vec3(0), {0, 0, 1});
    for (const double off : {0.0, 300.0, 410.0})
        for (const bool along : {false, true}) {
            ShapeBuilder shapes;
            std::vector<Vec3> bar =
                along ? level_rectangle(2000, 150, 1500) : level_rectangle(150, 2000, 1500);
            const Vec3 shift = along ? Vec3(0, off, 0) : Vec3(off, 0, 0);
            for (Vec3& corner : bar) corner += shift;
            add_plate(bar, shapes);
            std::vector<Vec3> strip =
                along ? level_rectangle(2000, 300, 3000) : level_rectangle(300, 2000, 3000);
            for (Vec3& corner : strip) corner += shift * 2;
            const PolygonLight hidden{strip, Rgb(1), true};
            const double exact = 1 - projected_solid_angle(hidden, Vec3(0), {0, 0, 1}) / whole;
            EXPECT_NEAR(seen_share(light, shapes.model(), {3e-3, 1, true}), exact, 3e-3) << off;
        }
}

/// A body of two faces between a receiver at 0 and lights above: a sphere and a sail.
SurfaceModel sphere_and_sail() {
    ShapeBuilder shapes;
    shapes.face(sphere({-150, 60, 420}, 110));
    PatchData sail{2, 2, {}, {}, {}};
    for (const Vec3& p : {Vec3(40, -160, 300), Vec3(90, -40, 420), Vec3(40, 120, 330),
                          Vec3(160, -170, 380), Vec3(200, -20, 560), Vec3(140, 130, 420),
                          Vec3(260, -120, 330), Vec3(280, 10, 380), Vec3(230, 160, 300)})
        sail.points.emplace_back(p.x, p.y, p.z, 1);
    shapes.face({sail});
    return shapes.model();
}

/// Visible share of a light from 0 by rays to the middles of a grid of cells of the outline that it
/// has there.
double share_by_rays(const Tracer& tracer, const Vec3& normal, const std::vector<Vec3>& middles,
                     const Vec3& light_normal) {
    double all = 0, seen = 0;
    std::vector<Ray> rays;
    std::vector<double> light;
    for (const Vec3& at : middles) {
        const double cosines = std::max(normal.dot(at), 0.0) * std::abs(light_normal.dot(at));
        if (!(cosines > 0)) continue;
        Ray ray;
        ray.direction = at, ray.t_max = 1;
        rays.push_back(ray);
        light.push_back(cosines / (at.length2() * at.length2()));
    }
    const std::vector<bool> hidden = tracer.any(std::span<const Ray>(rays));
    for (std::size_t i = 0; i < rays.size(); ++i) all += light[i], seen += hidden[i] ? 0 : light[i];
    return seen / all;
}

/// Half a million rays see a share to about 3e-5.
TEST(AreaPenumbra, BehindCurvedPatchesMeetsRays) {
    constexpr int side = 700;
    const SurfaceModel model = sphere_and_sail();
    const Tracer tracer(model);
    const Occluders occluders(model, tracer);
    const PolygonLight panel{
        {{-500, -300, 900}, {-500, 400, 1000}, {500, 400, 1000}, {500, -300, 900}}};
    const SphereLight globe{{120, -40, 900}, 350, Rgb(1)};
    const Disc outline = outline_of(globe, Vec3(0));
    const Vec3 u = outline.normal.cross(Vec3(0, 1, 0)).normalized(), v = outline.normal.cross(u);
    std::vector<Vec3> on_panel, on_globe;
    for (int i = 0; i < side; ++i)
        for (int k = 0; k < side; ++k) {
            const double s = (i + 0.5) / side, t = (k + 0.5) / side;
            const Vec3& first = panel.corners[0];
            on_panel.push_back(first + (panel.corners[3] - first) * s +
                               (panel.corners[1] - first) * t);
            const Vec2 at(2 * s - 1, 2 * t - 1);
            if (at.length() < 1)
                on_globe.push_back(outline.center + (u * at.x + v * at.y) * outline.radius);
        }
    for (const Vec3& normal : {Vec3(0, 0, 1), Vec3(0.8, 0.36, 0.48)}) {
        const auto seen = [&](const auto& light) {
            const OccludedVisibility visible(&occluders, tracer, Viewpoint::at(Vec3(0)),
                                             bounds_of(light), {}, normal);
            return visible_share(light, Vec3(0), normal, visible, of_numbers);
        };
        const double of_panel = share_by_rays(tracer, normal, on_panel, panel.normal());
        EXPECT_LT(of_panel, 0.95);
        EXPECT_NEAR(seen(panel), of_panel, 1e-4);
        const double of_globe = share_by_rays(tracer, normal, on_globe, outline.normal);
        EXPECT_LT(of_globe, 0.95);
        EXPECT_NEAR(seen(globe), of_globe, 1e-4);
    }
}

} // namespace
} // namespace keiko
