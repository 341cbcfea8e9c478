#include "keiko/workflow/analysis_picture.h"

#include "keiko/api/render.h"
#include "keiko/api/scene.h"
#include "keiko/film/signed_color_picture.h"

#include "tests/support/analytic_models.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <string>

namespace keiko {
namespace {

using std::numbers::pi;

/// A body seen from far off, along -x, one pixel a mm, in all layers.
struct Body {
    Camera camera;
    Film film;

    explicit Body(const SurfaceModel& model) {
        camera.projection = Projection::orthographic;
        camera.eye = {1000, 0, 0}, camera.target = {0, 0, 0};
        camera.orthographic_height = 200, camera.width = 200, camera.height = 200;
        TracerOptions options;
        options.second_derivatives = true;
        const std::vector<Material> paint(model.faces.size());
        film = render({Tracer(model, options), paint, {}}, camera, {.aovs = every_aov()});
    }
};

/// A ball of 100 mm.
struct Ball : Body {
    Ball() : Body(test::sphere_model(test::stretched(Vec3(100), {0, 0, 1}, Vec3(0)))) {}
    /// Elevation of the normal seen in a pixel of the middle column, degrees.
    static double elevation(int y) { return std::asin((99.5 - y) / 100) * 180 / pi; }
};

TEST(AnalysisMode, HasANameEach) {
    for (const AnalysisMode look : every_look())
        EXPECT_EQ(is_curvature(look), name_of(look).starts_with("curvature:"));
    EXPECT_EQ(every_look().size(), 15u);
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
        AnalysisOptions options;
        if (full) options.scale.range = ValueRange{-*full, *full};
        return analysis_picture(AnalysisMode::gauss, ball.film, ball.camera, {}, options).values;
    };
    EXPECT_EQ(picture(1e-4), picture({}));
    EXPECT_NE(picture(2e-4), picture({}));
}

/// Hue of a pixel of a draft picture.
std::string hue(const Image& picture, int y) {
    const float* p = picture.pixel(100, y);
    if (p[2] > p[0]) return "blue";
    return p[1] > 0.6f * p[0] ? "yellow" : "red";
}

/// The draft angle against the vertical is the elevation of the normal.
TEST(AnalysisMode, DraftIsColoredByItsSignAndMinimum) {
    const Ball ball;
    AnalysisOptions options;
    options.draft = 10;
    const auto expected = [](double angle) {
        return angle < 0 ? "red" : angle < 10 ? "yellow" : "blue";
    };
    for (const bool turned : {false, true}) {
        options.pull = Vec3(0, 0, turned ? -2 : 1);
        const Image picture =
            analysis_picture(AnalysisMode::draft, ball.film, ball.camera, {}, options);
        EXPECT_GT(picture.width, 200);
        int compared = 0;
        for (int y = 5; y < 160; ++y) { // above the caption
            const double angle = (turned ? -1 : 1) * Ball::elevation(y);
            if (std::abs(angle) < 1 || std::abs(angle - 10) < 1) continue; // within the pixel
            EXPECT_EQ(hue(picture, y), expected(angle)) << "row " << y << " " << angle;
            ++compared;
        }
        EXPECT_GT(compared, 130);
    }
}

TEST(AnalysisMode, DraftColorsEndAtTheScale) {
    const Ball ball;
    AnalysisOptions options;
    const auto blue_over_red = [&](int y) {
        const Image picture =
            analysis_picture(AnalysisMode::draft, ball.film, ball.camera, {}, options);
        return double{picture.pixel(100, y)[2]} / double{picture.pixel(100, y)[0]};
    };
    options.scale.range = ValueRange{-20, 20};
    EXPECT_NEAR(blue_over_red(60), blue_over_red(40), 1e-4); // 23 and 36 degrees
    options.scale.range = ValueRange{-60, 60};
    EXPECT_LT(blue_over_red(60), 0.9 * blue_over_red(40));
    options.scale = {.range = {}, .percentile = 100}; // 90 degrees
    EXPECT_LT(blue_over_red(60), 0.9 * blue_over_red(40));
}

TEST(AnalysisMode, OnlyTheBodyHasDraftColors) {
    const Ball ball;
    AnalysisOptions options;
    options.ground = 0;
    const Image picture =
        analysis_picture(AnalysisMode::draft, ball.film, ball.camera, {}, options);
    const float* pixel = picture.pixel(100, 40);
    EXPECT_EQ(pixel[0], pixel[2]);
    EXPECT_GT(pixel[0], 0.2f);
}

/// A cylinder of 80 mm about z. It bulges with 1/80 along sections square to z, with 0 along z and
/// with half of 1/80 at 45 degrees between.
TEST(AnalysisMode, SectionCurvatureFollowsEuler) {
    const SurfaceModel model =
        test::cylinder_model(test::stretched({80, 80, 90}, {0, 0, 1}, Vec3(0)));
    const Body tube(model);
    TracerOptions second;
    second.second_derivatives = true;
    const Tracer tracer(model, second);
    const auto middle = [&](const Vec3& normal) {
        return *section_curvatures(tracer, tube.camera, normal).pixel(100, 90);
    };
    EXPECT_NEAR(middle({0, 0, 1}), -1 / 80.0, 1e-7);
    EXPECT_NEAR(middle({0, 3, 0}), 0, 1e-7);
    EXPECT_NEAR(middle({0, 1, 1}), -0.5 / 80, 1e-6);
    EXPECT_TRUE(std::isnan(*section_curvatures(tracer, tube.camera, {0, 0, 1}).pixel(0, 0)));

    AnalysisOptions options;
    options.sections = section_curvatures(tracer, tube.camera, {0, 0, 1});
    options.scale.range = ValueRange{-1 / 80.0, 1 / 80.0};
    const Image picture =
        analysis_picture(AnalysisMode::section, tube.film, tube.camera, {}, options);
    EXPECT_NEAR(picture.pixel(100, 90)[2], signed_color(-1).b, 0.01);
    EXPECT_NEAR(picture.pixel(100, 90)[0], signed_color(-1).r, 0.01);
}

/// The tube of a torus has 30 mm. Its outermost circle has 70 + 30 mm the other way.
TEST(AnalysisMode, RadiusIsThatOfTheLargestCurvature) {
    const Body ring(test::torus_model(60, 30));
    const auto color = [&](AnalysisMode look, const AnalysisOptions& options) {
        const float* p =
            analysis_picture(look, ring.film, ring.camera, {}, options).pixel(100, 100);
        return Rgb(double{p[0]}, double{p[1]}, double{p[2]});
    };
    AnalysisOptions options;
    options.scale.range = ValueRange{3, 300}; // 30 lies in its middle
    const Rgb middle = color(AnalysisMode::radius, options);
    EXPECT_NEAR(middle.g, 1, 0.02);
    EXPECT_LT(middle.r + middle.b, 0.1);
    options.scale.range = ValueRange{30, 300};
    EXPECT_NEAR(color(AnalysisMode::radius, options).r, 1, 0.02);
    // |k1| + |k2| = 1/30 + 1/90 = 2/45
    options.scale.range = ValueRange{0, 4 / 45.0};
    EXPECT_NEAR(color(AnalysisMode::absolute, options).g, 1, 0.02);
    options.radius = 30.1;
    const Rgb narrow = color(AnalysisMode::below_radius, options);
    EXPECT_GT(narrow.r, 3 * narrow.b);
    options.radius = 29.9;
    const Rgb wide = color(AnalysisMode::below_radius, options);
    EXPECT_EQ(wide.r, wide.b);
}

/// A square of 160 mm of 2 x 2 patches, each of 80 mm, seen face on: lines lie 20 mm apart.
struct Quilt : Body {
    Quilt() : Body(model()) {}
    static SurfaceModel model() {
        test::ModelBuilder builder;
        NurbsSurface sheet{1, 1, {0, 0, 0.5, 1, 1}, {0, 0, 0.5, 1, 1}, {}};
        for (const double y : {-80, 0, 80})
            for (const double z : {-80, 0, 80}) sheet.points.emplace_back(0, y, z, 1);
        builder.nurbs(sheet);
        return builder.build();
    }
};

TEST(AnalysisMode, IsoparmsLieAtEvenParametersAndBorders) {
    const Quilt quilt;
    const Image picture = analysis_picture(AnalysisMode::isoparms, quilt.film, quilt.camera, {});
    for (int y = 0; y < 200; ++y) {
        const float* p = picture.pixel(110, y);
        const bool inside = y >= 20 && y < 180;
        const double beside = std::abs(std::remainder(y + 0.5 - 100, 20));
        if (inside && beside > 3) {
            EXPECT_NEAR(p[1], 0.86, 0.01) << y; // on no line
        }
        if (inside && beside < 1 && y > 25 && y < 175) {
            EXPECT_LT(p[1], 0.75) << y;
        }
    }
    // The knot line in the middle is darker and wider than the others.
    EXPECT_LT(picture.pixel(110, 99)[1], 0.45);
    EXPECT_LT(picture.pixel(110, 100)[1], 0.45);
    EXPECT_LT(picture.pixel(110, 20)[1], 0.1); // the border of the face is black
}

TEST(AnalysisMode, PatchesHaveColorsOfTheirOwn) {
    const Quilt quilt;
    const Image picture = analysis_picture(AnalysisMode::patches, quilt.film, quilt.camera, {});
    const auto color = [&](int x, int y) {
        const float* p = picture.pixel(x, y);
        return std::array{p[0], p[1], p[2]};
    };
    const std::set<std::array<float, 3>> colors{color(60, 60), color(60, 140), color(140, 60),
                                                color(140, 140)};
    EXPECT_EQ(colors.size(), 4u);
    EXPECT_EQ(color(60, 60), color(90, 70));
    EXPECT_LT(picture.pixel(100, 60)[1], 0.6); // a border
    EXPECT_EQ(picture.values,
              analysis_picture(AnalysisMode::patches, quilt.film, quilt.camera, {}).values);
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

/// Normals of a ball about the origin meet a globe, or a disc's or a panel's plane, within an
/// angle.
TEST(AnalysisMode, HighlightsShowPanelsAndGlobes) {
    const Ball ball;
    const double a = 600;
    const PolygonLight panel{{{-a, -a, 1000}, {-a, a, 1000}, {a, a, 1000}, {a, -a, 1000}}};
    const std::vector<std::pair<LightSource, double>> lights{
        {SphereLight{{0, 0, 1000}, a}, std::asin(a / 1000)},
        {DiscLight{{0, 0, 1000}, {0, 0, -1}, a}, std::atan(a / 1000)},
        {panel, std::atan(a / 1000)}};
    for (const auto& [light, widest] : lights) {
        LightRig rig;
        rig.sources = {light};
        const Image picture =
            analysis_picture(AnalysisMode::highlight, ball.film, ball.camera, rig);
        int bright = 0, dark = 0;
        for (int y = 2; y < 95; ++y) {
            const double angle = pi / 2 - Ball::elevation(y) * pi / 180;
            if (std::abs(angle - widest) < 0.05) continue;
            const bool is_bright = *picture.pixel(100, y) > 0.3f;
            EXPECT_EQ(is_bright, angle < widest) << y;
            ++(is_bright ? bright : dark);
        }
        EXPECT_GT(bright, 5);
        EXPECT_GT(dark, 5);
    }
}

} // namespace
} // namespace keiko
