#include "keiko/inspect/lines/surface_lines.h"

#include "keiko/import/worker/load_model.h"
#include "keiko/intersect/hit/reflect_ray.h"
#include "keiko/scene/view.h"

#include "tests/support/analytic_models.h"
#include "tests/support/paths.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

/// Twelve lamps, along y, over a box, as wide and deep as 3 of its sizes.
CPlane lamps_over(const Box3& body) {
    const double size = body.size();
    CPlane lamps;
    lamps.origin = body.center() + Vec3(-1.5, -1.5, 1.2) * size;
    lamps.u = {0, 3 * size, 0}, lamps.v = {3 * size, 0, 0};
    return lamps;
}

struct Compared {
    int points = 0, hidden = 0;
};

/// Every point must be the first hit of the eye's ray through it, and mirror to its lamp's axis.
Compared compare(const SurfaceModel& model, const Tracer& tracer, const Camera& camera,
                 const CPlane& plane, const std::vector<SurfaceLine>& lines, double within) {
    const CPlaneFrame frame(plane);
    Compared compared;
    for (const SurfaceLine& line : lines)
        for (std::size_t i = 1; i + 1 < line.line.points.size(); ++i) {
            const Vec3 place = line.line.points[i].place;
            Ray ray;
            ray.origin = camera.eye, ray.direction = (place - camera.eye).normalized();
            const std::optional<Hit> hit = tracer.nearest(ray);
            if (!hit || (hit->position - place).length() > 1e-6) {
                ++compared.hidden;
                continue;
            }
            const Ray mirrored = reflect_ray(ray, *hit);
            const Vec3 from = frame.point(mirrored.origin),
                       slope = frame.vector(mirrored.direction);
            const double reach = -from.z / slope.z;
            // A place moved by a small step moves its image by a multiple of it: `within` is of
            // the image, so that the place is nearer still.
            EXPECT_NEAR(from.y + reach * slope.y, frame.axis(static_cast<int>(line.lamp)), within)
                << model.describe(model.faces[line.face]) << place;
            const double along = from.x + reach * slope.x;
            EXPECT_TRUE(along > -1e-6 && along < frame.length + 1e-6) << along;
            Ray free = mirrored;
            free.t_max = reach / mirrored.direction.length();
            EXPECT_FALSE(tracer.any(free)) << place;
            ++compared.points;
        }
    return compared;
}

Camera camera_of(const char* view, const Box3& body) {
    return frame_view(view, body);
}

TEST(SurfaceLines, OnASphereAreWhereTheEyeSeesTheLamps) {
    const SurfaceModel model =
        test::sphere_model(Affine::translate({100, 200, 700}) * Affine::scale(400));
    const Tracer tracer(model);
    const Camera camera = camera_of("high-front", tracer.bounds());
    const CPlane lamps = lamps_over(tracer.bounds());
    const auto lines = surface_lines(model, tracer, std::array{LineSource(lamps)}, camera);
    const Compared compared = compare(model, tracer, camera, lamps, lines, 1e-6);
    EXPECT_GT(compared.points, 200);
    EXPECT_EQ(compared.hidden, 0);
}

TEST(SurfaceLines, OnTheHoodAreWhereTheEyeSeesTheLamps) {
    const SurfaceModel model = load_model(test::repository("surfaces/hood.step"));
    const Tracer tracer(model);
    const Camera camera = camera_of("high-front", tracer.bounds());
    const CPlane lamps = lamps_over(tracer.bounds());
    const auto lines = surface_lines(model, tracer, std::array{LineSource(lamps)}, camera);
    const Compared compared = compare(model, tracer, camera, lamps, lines, 1e-6);
    EXPECT_GT(compared.points, 500);
    EXPECT_EQ(compared.hidden, 0);
}

/// A flat sheet of 200 mm with a square hole of 60 mm about its middle.
SurfaceModel sheet_with_hole() {
    test::ModelBuilder builder;
    builder.plane({-100, -100, 0}, {200, 0, 0}, {0, 200, 0});
    builder.polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    builder.polygon({{0.35, 0.35}, {0.35, 0.65}, {0.65, 0.65}, {0.65, 0.35}});
    return builder.build();
}

TEST(SurfaceLines, StopAtTheBorderOfAHole) {
    const SurfaceModel model = sheet_with_hole();
    const Tracer tracer(model);
    const Camera camera = camera_of("high-front", tracer.bounds());
    CPlane lamps;
    lamps.origin = {-1000, -1000, 500}, lamps.u = {2000, 0, 0}, lamps.v = {0, 2000, 0};
    lamps.lamps = 101;
    double nearest_end = 1000;
    bool beside = false;
    for (const SurfaceLine& line :
         surface_lines(model, tracer, std::array{LineSource(lamps)}, camera)) {
        for (const LinePoint& p : line.line.points) {
            const double out = std::max(std::abs(p.place.x), std::abs(p.place.y)) - 30;
            EXPECT_GE(out, -1e-9) << p.place;
            nearest_end = std::min(nearest_end, out);
        }
        beside = true;
    }
    EXPECT_TRUE(beside);
    EXPECT_LT(nearest_end, 1e-8) << "no line reaches the hole";
}

/// A sheet 100 mm under a smaller one.
SurfaceModel stacked_sheets() {
    test::ModelBuilder builder;
    builder.plane({-100, -100, 0}, {200, 0, 0}, {0, 200, 0});
    builder.plane({-50, -50, 100}, {100, 0, 0}, {0, 100, 0});
    return builder.build();
}

TEST(SurfaceLines, StopWhereAnotherSurfaceHidesThePlaceOrItsLamp) {
    const SurfaceModel model = stacked_sheets();
    const Tracer tracer(model);
    Camera camera;
    camera.eye = {0, -2000, 2000}, camera.target = {0, 0, 0};
    CPlane lamps;
    lamps.origin = {-5000, -5000, 2000}, lamps.u = {0, 10000, 0}, lamps.v = {10000, 0, 0};
    lamps.lamps = 400;
    const auto lines = surface_lines(model, tracer, std::array{LineSource(lamps)}, camera);
    // By similar triangles the ray to the eye from (x, y, 0) is at 0.95 y - 100 where it passes the
    // upper sheet. The mirrored one is at 1.05 y + 100; the sheet ends at -50 and at 50.
    double front = 100, rear = -100;
    for (const SurfaceLine& line : lines)
        for (const LinePoint& p : line.line.points) {
            if (line.face != 0 || std::abs(p.place.x) > 45) continue;
            front = std::min(front, p.place.y);
            rear = std::max(rear, p.place.y);
        }
    EXPECT_NEAR(front, -50 / 1.05, 1e-6) << "behind it the mirrored ray is free";
    EXPECT_NEAR(rear, 50 / 0.95, 1e-6) << "before it the ray to the eye is free";
}

TEST(SurfaceLines, AreTheSameForOneAndTwoThreads) {
    const SurfaceModel model = load_model(test::repository("surfaces/trimmed-hole.step"));
    const Tracer tracer(model);
    const Camera camera = camera_of("high-front", tracer.bounds());
    const CPlane lamps = lamps_over(tracer.bounds());
    for (const LineLook look : {LineLook::reflection, LineLook::highlight, LineLook::isophote}) {
        SurfaceLineOptions options;
        options.look = look;
        const auto one = surface_lines(model, tracer, std::array{LineSource(lamps)}, camera,
                                       options, {.threads = 1});
        const auto two = surface_lines(model, tracer, std::array{LineSource(lamps)}, camera,
                                       options, {.threads = 2});
        EXPECT_FALSE(one.empty()) << name_of(look);
        ASSERT_EQ(one.size(), two.size());
        for (std::size_t i = 0; i < one.size(); ++i) {
            ASSERT_EQ(one[i].line.points.size(), two[i].line.points.size());
            for (std::size_t k = 0; k < one[i].line.points.size(); ++k)
                EXPECT_EQ(one[i].line.points[k].place, two[i].line.points[k].place);
        }
    }
}

} // namespace
} // namespace keiko
