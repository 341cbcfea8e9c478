#include "keiko/workflow/glass_deviation.h"

#include "keiko/base/error.h"
#include "keiko/base/units.h"
#include "keiko/render/shading/picture.h"
#include "keiko/workflow/analysis_picture.h"

#include "tests/support/oracle.h"
#include "tests/support/shapes.h"
#include <gtest/gtest.h>

#include <cmath>

namespace keiko {
namespace {

using test::OracleRow;
using test::OracleTable;

struct Pane {
    SurfaceModel model;
    Tracer tracer;
    std::vector<Material> materials;

    Pane(SurfaceModel body, double n, double thickness)
        : model(std::move(body)),
          tracer(model, {.second_derivatives = true}),
          materials(model.faces.size()) {
        for (Material& material : materials) {
            material.refractive_index = n;
            material.glass = Glass{Rgb(0), thickness};
        }
    }
    Image deviations(const Camera& camera) const {
        return glass_deviations(tracer, materials, camera);
    }
};

/// A camera whose only pixel looks along a ray.
Camera along(const Vec3& origin, const Vec3& direction) {
    Camera camera;
    camera.eye = origin, camera.target = origin + direction * 1000;
    camera.vertical_fov = 0.01, camera.width = 1, camera.height = 1;
    return camera;
}

/// Spherical shells about the origin.
SurfaceModel shells(std::initializer_list<double> radii) {
    test::ShapeBuilder builder;
    for (const double radius : radii) builder.face(test::sphere(Vec3(0), radius));
    return builder.model();
}

TEST(GlassDeviation, BallsTurnTheSightAsTheOracleSays) {
    for (const OracleRow& row : OracleTable("glass_ball")) {
        const Pane ball(
            test::ShapeBuilder().face(test::sphere(row.vector("in.C"), row.number("in.R"))).model(),
            row.number("in.n"), 0);
        const Image image = ball.deviations(along(row.vector("in.O"), row.unit("in.dir")));
        const double wanted = 1e3 * degrees_to_radians(row.number("out.dev_deg"));
        EXPECT_NEAR(double{image.pixel(0, 0)[0]}, wanted, 1e-4 + 1e-6 * wanted) << row.id();
    }
}

TEST(GlassDeviation, ABentPaneTurnsLikeTheSolidThatItStandsFor) {
    constexpr double radius = 2500, thickness = 5;
    const Pane pane(shells({radius}), 1.52, thickness); // seen from inside
    const Pane solid(shells({radius, radius + thickness}), 1.52, 0);
    double largest = 0;
    for (const double height : {-900.0, 300.0, 1300.0, 1900.0}) {
        const Camera camera = along({0, 0, height}, Vec3(-1, 0.1, 0.2).normalized());
        const double bent{pane.deviations(camera).pixel(0, 0)[0]};
        const double wanted{solid.deviations(camera).pixel(0, 0)[0]};
        EXPECT_NEAR(bent, wanted, 5e-3 * wanted) << height;
        largest = std::max(largest, wanted);
    }
    EXPECT_GT(largest, 0.5);
}

TEST(GlassDeviation, IsUnknownWhereThePanesFarSideReflectsTotally) {
    const Pane pane(shells({100}), 1.5, 5);
    const auto turned = [&](double beside) {
        return pane.deviations(along({-500, 0, beside}, {1, 0, 0})).pixel(0, 0)[0];
    };
    EXPECT_GT(turned(93), 50);
    EXPECT_TRUE(std::isnan(turned(98)));
}

TEST(GlassDeviation, FlatPanesTurnNothingAndOpaqueFacesAreNoGlass) {
    const Pane pane(test::ShapeBuilder().face({test::rectangle(-50, 50, -50, 50, 0)}).model(), 1.5,
                    6);
    Camera camera;
    camera.eye = {0, -300, 200}, camera.target = {0, 0, 0};
    camera.vertical_fov = 60, camera.width = 21, camera.height = 21;
    const Image image = pane.deviations(camera);
    EXPECT_LT(image.pixel(10, 10)[0], 1e-4F);
    EXPECT_TRUE(std::isnan(image.pixel(0, 0)[0]));
    // Behind a flat pane the grid is where it is without.
    const Ray ray = camera.ray(12.5, 9.5);
    const CameraAxes axes = camera.axes();
    const double depth = ray.direction.dot(axes.forward);
    EXPECT_NEAR(double{image.pixel(12, 9)[1]}, ray.direction.dot(axes.right) / depth, 1e-6);
    EXPECT_NEAR(double{image.pixel(12, 9)[2]}, ray.direction.dot(axes.up) / depth, 1e-6);

    const std::vector<Material> paint(pane.model.faces.size());
    const Image none = glass_deviations(pane.tracer, paint, camera);
    EXPECT_TRUE(std::isnan(none.pixel(10, 10)[0]));
}

TEST(GlassDeviation, PicturesShowTheAngleByColourAndNeedGlass) {
    const Pane ball(test::ShapeBuilder().face(test::sphere({0, 0, 0}, 100)).model(), 1.5, 0);
    Camera camera;
    camera.eye = {0, -800, 0}, camera.target = {0, 0, 0};
    camera.vertical_fov = 20, camera.width = 120, camera.height = 90;
    const LightRig dark;
    const Film film = render({ball.tracer, ball.materials, dark}, camera,
                             {.aovs = look_layers(AnalysisMode::distortion), .max_depth = 0});
    AnalysisOptions options;
    options.deviations = ball.deviations(camera);
    const Image picture = analysis_picture(AnalysisMode::distortion, film, camera, dark, options);
    // Blue in the middle, where nothing turns, and red towards the rim.
    const float* middle = picture.pixel(61, 44);
    EXPECT_GT(middle[2], middle[0]);
    bool red = false; // where the grid is too fine for lines
    for (int x = 20; x < 60; ++x)
        red = red || picture.pixel(x, 44)[0] > 0.3f + picture.pixel(x, 44)[2];
    EXPECT_TRUE(red);

    options.deviations = glass_deviations(ball.tracer, std::vector<Material>(1), camera);
    EXPECT_THROW(analysis_picture(AnalysisMode::distortion, film, camera, dark, options), Error);
}

} // namespace
} // namespace keiko
