#include "keiko/workflow/analysis_picture.h"

#include "keiko/api/render.h"
#include "keiko/api/scene.h"

#include "tests/support/analytic_models.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

using std::numbers::pi;

/// A ball of 100 mm seen from far off, along -x, 200 pixels high.
struct Ball {
    Camera camera;
    Film film;

    Ball() {
        camera.projection = Projection::orthographic;
        camera.eye = {1000, 0, 0}, camera.target = {0, 0, 0};
        camera.orthographic_height = 200, camera.width = 200, camera.height = 200;
        TracerOptions options;
        options.second_derivatives = true;
        const SurfaceModel model =
            test::sphere_model(test::stretched(Vec3(100), {0, 0, 1}, Vec3(0)));
        const std::vector<Material> paint(1);
        film = render({Tracer(model, options), paint, {}}, camera, {.aovs = look_layers()});
    }
    /// Elevation of the normal seen in a pixel of the middle column, degrees.
    static double elevation(int y) { return std::asin((99.5 - y) / 100) * 180 / pi; }
};

TEST(AnalysisMode, HasANameEach) {
    for (const AnalysisMode look : every_look())
        EXPECT_EQ(is_curvature(look), name_of(look).starts_with("curvature:"));
    EXPECT_EQ(every_look().size(), 7u);
}

/// Bands of 2.5 degrees of the normal, and of 5 degrees of the reflected ray: on a ball seen level
/// these are the same.
TEST(AnalysisMode, BandsLieAtTheirAngles) {
    const Ball ball;
    for (const AnalysisMode look : {AnalysisMode::isophote, AnalysisMode::zebra}) {
        const Image picture = analysis_picture(look, ball.film, ball.camera, {});
        int compared = 0;
        for (int y = 30; y < 170; ++y) {
            // The reflected ray of a level view rises twice as far as the normal.
            const double angle = 90 - Ball::elevation(y);
            const double zenith =
                look == AnalysisMode::isophote ? angle : 90 - 2 * Ball::elevation(y);
            const double phase =
                look == AnalysisMode::isophote ? zenith / 2.5 : std::abs(zenith) / 5;
            const double off = std::abs(phase - std::round(phase));
            if (off < 0.35) continue; // a border is within the pixel
            const bool light = static_cast<int>(std::floor(phase)) % 2 == 1;
            const float value = *picture.pixel(100, y);
            EXPECT_EQ(value > 0.45f, light) << name_of(look) << " row " << y << " " << value;
            ++compared;
        }
        EXPECT_GT(compared, 20) << name_of(look);
    }
}

/// A ball bulges: its principal curvatures are -1/100 to the eye, its Gaussian curvature is
/// positive.
TEST(AnalysisMode, CurvaturesAreAsTheEyeSeesThem) {
    const Ball ball;
    const auto red_over_blue = [&](AnalysisMode look) {
        const Image picture = analysis_picture(look, ball.film, ball.camera, {});
        const float* pixel = picture.pixel(100, 80);
        return pixel[0] - pixel[2];
    };
    EXPECT_GT(red_over_blue(AnalysisMode::gauss), 0.1);
    for (const AnalysisMode look : {AnalysisMode::mean, AnalysisMode::k1, AnalysisMode::k2})
        EXPECT_LT(red_over_blue(look), -0.1);
    const Image& k = ball.film.aovs.at(Aov::curvature);
    EXPECT_NEAR(std::abs(k.pixel(100, 80)[0]), 0.01, 1e-7);
    EXPECT_NEAR(k.pixel(100, 80)[3], 1e-4, 1e-9);
}

TEST(AnalysisMode, CurvaturesAreFullWhereAsked) {
    const Ball ball;
    EXPECT_EQ(usual_curvature(AnalysisMode::gauss, ball.film, ball.camera), 1e-4);
    EXPECT_EQ(usual_curvature(AnalysisMode::k1, ball.film, ball.camera), 0.01);
    const auto picture = [&](std::optional<double> full) {
        return analysis_picture(AnalysisMode::gauss, ball.film, ball.camera, {}, full).values;
    };
    EXPECT_EQ(picture(1e-4), picture({}));
    EXPECT_NE(picture(2e-4), picture({}));
}

/// Normals of a ball about the origin meet the plane z = 1000 at x = 1000 tan(angle from z).
TEST(AnalysisMode, HighlightBandsFollowTheLamps) {
    const Ball ball;
    CPlane lamps;
    lamps.origin = {-2000, -2000, 1000}, lamps.u = {0, 4000, 0}, lamps.v = {4000, 0, 0};
    lamps.lamps = 8; // a pitch of 500 mm, the axes at -1750, -1250, ...
    LightRig rig;
    rig.sources.emplace_back(lamps);
    const Image picture = analysis_picture(AnalysisMode::highlight, ball.film, ball.camera, rig);
    int compared = 0;
    for (int y = 2; y < 95; ++y) {
        const double x = 1000 / std::tan(Ball::elevation(y) * pi / 180) * 0.999;
        const double from_axis = (x - 250) / 500 - std::round((x - 250) / 500);
        if (std::abs(std::abs(from_axis) - 0.25) < 0.12 || x > 1800) continue;
        const float value = *picture.pixel(100, y);
        EXPECT_EQ(value > 0.3f, std::abs(from_axis) > 0.25) << y << " " << x << " " << value;
        ++compared;
    }
    EXPECT_GT(compared, 10);
    // Without a plane there are no bands.
    const Image grey = analysis_picture(AnalysisMode::highlight, ball.film, ball.camera, {});
    EXPECT_NEAR(*grey.pixel(100, 60), *grey.pixel(100, 62), 0.02);
}

} // namespace
} // namespace keiko
