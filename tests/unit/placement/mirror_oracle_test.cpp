#include "keiko/base/units.h"
#include "keiko/placement/plane_frame.h"
#include "keiko/placement/view_samples.h"

#include "tests/support/analytic_models.h"
#include "tests/support/oracle.h"
#include <gtest/gtest.h>

#include <cmath>

namespace keiko {
namespace {

/// The mirror of a row: sphere (c, R), cylinder (point, axis, R) or ellipsoid (c, semi-axes).
SurfaceModel mirror(const test::OracleRow& row) {
    const std::vector<double> p = row.list("in.surf_p");
    const Vec3 center(p[0], p[1], p[2]);
    const std::string& kind = row.text("in.surf");
    if (kind == "cylinder")
        return test::cylinder_model(
            test::stretched({p[6], p[6], 4000}, {p[3], p[4], p[5]}, center));
    const Vec3 radii = kind == "sphere" ? Vec3(p[3]) : Vec3(p[3], p[4], p[5]);
    return test::sphere_model(test::stretched(radii, {0, 0, 1}, center));
}

/// A camera whose picture plane at distance 1 is `height` high.
Camera camera_of(const test::OracleRow& row, double height, int pixels_wide, int pixels_high) {
    Camera camera;
    camera.eye = row.vector("in.E");
    camera.target = camera.eye + row.unit("in.F");
    camera.up = row.unit("in.Up");
    camera.vertical_fov = radians_to_degrees(2 * std::atan(height / 2));
    camera.width = pixels_wide;
    camera.height = pixels_high;
    return camera;
}

PlaneFrame plane_of(const test::OracleRow& row) {
    return {row.vector("in.Oc"), row.unit("in.U"), row.unit("in.V")};
}

TEST(MirroredRay, MatchesTheMirrorJacobianOracle) {
    test::WorstError place("place"), gradient("gradient");
    for (const test::OracleRow& row : test::OracleTable("mirror_jacobian")) {
        const SurfaceModel model = mirror(row);
        const Tracer tracer(model);
        // Two pixels of size 1: pixel (x + 1, 1 - y) is the place (x, y) of the oracle.
        const Camera camera = camera_of(row, 2, 2, 2);
        const Ray eye = camera.ray(row.number("in.x") + 1, 1 - row.number("in.y"));
        const std::optional<Hit> hit = tracer.nearest(eye);
        ASSERT_TRUE(hit) << row.id();
        EXPECT_LT((hit->position - row.vector("out.X")).length(), 1e-7) << row.id();
        const Ray ray = mirrored_ray(model, *hit, eye);
        EXPECT_LT((ray.direction - row.vector("out.Rf")).length(), 1e-10) << row.id();
        const PlaneHit on_plane = meet(plane_of(row), ray).value();
        place.compare(row, on_plane.place.x, row.number("out.u"), 1e-8);
        place.compare(row, on_plane.place.y, row.number("out.v"), 1e-8);
        const PlaneHit::Gradients& g = on_plane.gradients.value();
        gradient.compare(row, g.u.x, row.number("out.du_dx"), 1e-7);
        gradient.compare(row, -g.u.y, row.number("out.du_dy"), 1e-7);
        gradient.compare(row, g.v.x, row.number("out.dv_dx"), 1e-7);
        gradient.compare(row, -g.v.y, row.number("out.dv_dy"), 1e-7);
        gradient.compare(row, g.v.length(), row.number("out.grad_v"), 1e-7);
    }
}

TEST(ViewSamples, MatchTheReflectHitsOracle) {
    test::WorstError omega("sum_omega"), mean("mean"), covariance("covariance");
    for (const test::OracleRow& row : test::OracleTable("reflect_hits")) {
        const SurfaceModel model = mirror(row);
        const Tracer tracer(model);
        const int width = row.integer("in.W"), height = row.integer("in.H");
        const Camera camera =
            camera_of(row, 2 * row.number("in.tx") * height / width, width, height);
        SamplingOptions every_pixel;
        every_pixel.samples = width * height;
        const auto samples = sample_views(tracer, model, std::span(&camera, 1), every_pixel);
        EXPECT_EQ(static_cast<int>(samples.size()), row.integer("out.n_surface")) << row.id();

        const PlaneFrame frame = plane_of(row);
        const Box2 rectangle{Vec2(row.number("in.ua"), row.number("in.va")),
                             Vec2(row.number("in.ub"), row.number("in.vb"))};
        const double clip = row.number("in.clip");
        int on_plane = 0, in_rectangle = 0, clipped = 0;
        double solid_angle = 0;
        Vec2 sum(0), squares(0);
        double product = 0;
        for (const ViewSample& s : samples) {
            EXPECT_FALSE(s.blocked) << row.id(); // convex
            const auto hit = meet(frame, s.mirror);
            if (!hit) continue;
            ++on_plane;
            const Vec2& p = hit->place;
            if (rectangle.contains(p)) ++in_rectangle, solid_angle += s.weight;
            if (!(std::abs(p.x) < clip && std::abs(p.y) < clip)) continue;
            ++clipped;
            sum += p;
            squares += p * p;
            product += p.x * p.y;
        }
        EXPECT_EQ(on_plane, row.integer("out.n_plane")) << row.id();
        EXPECT_EQ(in_rectangle, row.integer("out.n_rect")) << row.id();
        ASSERT_EQ(clipped, row.integer("out.n_clip")) << row.id();
        omega.compare(row, solid_angle, row.number("out.sum_omega"), 1e-10);
        const Vec2 m = sum / clipped;
        mean.compare(row, m.x, row.number("out.mean_u"), 1e-7);
        mean.compare(row, m.y, row.number("out.mean_v"), 1e-7);
        covariance.compare(row, squares.x / clipped - m.x * m.x, row.number("out.cov_uu"), 1e-8);
        covariance.compare(row, squares.y / clipped - m.y * m.y, row.number("out.cov_vv"), 1e-8);
        covariance.compare(row, product / clipped - m.x * m.y, row.number("out.cov_uv"), 1e-7);
    }
}

/// Two square mirrors at a right angle, the floor seen from the front and above.
TEST(ViewSamples, TellWhereTheBodyMirrorsItself) {
    test::ModelBuilder builder;
    const std::uint32_t floor = builder.plane({0, -500, 0}, {1000, 0, 0}, {0, 1000, 0});
    builder.plane({1000, -500, 0}, {0, 1000, 0}, {0, 0, 1000});
    const SurfaceModel model = builder.build();
    const Tracer tracer(model);
    Camera camera;
    camera.eye = {-2000, 0, 1000};
    camera.target = {500, 0, 300};
    camera.width = 60;
    camera.height = 40;
    std::size_t blocked = 0, of_floor = 0;
    for (const ViewSample& s : sample_views(tracer, model, std::span(&camera, 1), {})) {
        if (s.face != floor) continue;
        ++of_floor;
        const double rise = -s.mirror.direction.z / s.mirror.direction.x; // of the reflected ray
        const double at_wall = s.position().z - rise * (1000 - s.position().x);
        const double aside =
            s.position().y + s.mirror.direction.y / s.mirror.direction.x * (1000 - s.position().x);
        const bool meets_wall = at_wall < 1000 && std::abs(aside) < 500;
        EXPECT_EQ(s.blocked, meets_wall);
        blocked += s.blocked ? 1 : 0;
    }
    EXPECT_GT(of_floor, 100u);
    EXPECT_GT(blocked, of_floor / 2);
}

TEST(ViewSamples, CountOnlyTheChosenFaces) {
    test::ModelBuilder builder;
    builder.plane({0, -500, 0}, {1000, 0, 0}, {0, 1000, 0});
    const std::uint32_t wall = builder.plane({1000, -500, 0}, {0, 1000, 0}, {0, 0, 1000});
    const SurfaceModel model = builder.build();
    const Tracer tracer(model);
    Camera camera;
    camera.eye = {-2000, 0, 1000};
    camera.target = {500, 0, 300};
    SamplingOptions options;
    options.samples = 2000;
    const auto all = sample_views(tracer, model, std::span(&camera, 1), options);
    options.faces = {wall};
    const auto chosen = sample_views(tracer, model, std::span(&camera, 1), options);
    EXPECT_GT(chosen.size(), 100u);
    EXPECT_LT(chosen.size(), all.size());
    for (const ViewSample& s : chosen) EXPECT_EQ(s.face, wall);
}

TEST(ViewSamples, ThinningKeepsTheWeight) {
    const SurfaceModel model = test::sphere_model(Affine::scale(500));
    const Tracer tracer(model);
    Camera camera;
    camera.eye = {-3000, 0, 0};
    camera.target = {0, 0, 0};
    const auto weight = [&](int samples, SampleWeight kind) {
        double sum = 0;
        const SamplingOptions options{samples, kind, {}};
        for (const auto& s : sample_views(tracer, model, std::span(&camera, 1), options))
            sum += s.weight;
        return sum;
    };
    // A sphere of angular radius asin(1/6): its solid angle is known.
    const double exact = 2 * std::numbers::pi * (1 - std::sqrt(1 - 1.0 / 36));
    EXPECT_NEAR(weight(40000, SampleWeight::solid_angle) / exact, 1, 2e-3);
    EXPECT_NEAR(weight(4000, SampleWeight::solid_angle) / exact, 1, 2e-2);
    EXPECT_NEAR(weight(4000, SampleWeight::pixels) / weight(40000, SampleWeight::pixels), 1, 2e-2);
}

} // namespace
} // namespace keiko
