#include "keiko/light/sky/sky_irradiance.h"
#include "keiko/light/sky/sky_panels.h"
#include "keiko/math/quadrature.h"

#include "tests/support/random.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

const std::vector<SkyModel> models{SkyModel::uniform, SkyModel::overcast, SkyModel::gradient,
                                   SkyModel::clear};

SkyLight some_sky(SkyModel model) {
    SkyLight sky{model, Rgb(1)};
    sky.horizon = 0.25;
    sky.sun = Vec3(0.4, 0.5, 0.6).normalized();
    return sky;
}

/// Light of the lines of a width, from t = `begin` to `end` of each.
double sum_over_lines(const SkyWidth& width, double begin, double end) {
    double sum = 0;
    const std::vector<double> cuts = width.cuts();
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
        sum += integrate(
            [&](double place) {
                const SubAxis axis = width.sub_axis(place);
                return width.lit(axis, begin, end) * axis.weight;
            },
            cuts[i], cuts[i + 1], 48);
    return sum;
}

/// Open skies, and a concave window that is half above the point.
TEST(SkyWidth, LinesAddUpToThePanel) {
    test::Random random(3);
    for (const SkyModel model : models) {
        SkyLight sky = some_sky(model);
        const Vec3 point(100, -200, 700);
        for (const bool windows : {false, true}) {
            if (windows)
                sky.windows = {{{{2000, -900, 300},
                                 {2000, 900, 300},
                                 {2000, 900, 1900},
                                 {2000, 100, 800},
                                 {2000, -900, 2100}}}};
            for (int i = 0; i < 10; ++i) {
                const Vec3 normal = test::random_direction(random);
                for (int k = 0; k < panel_count(sky); ++k) {
                    const auto panel = sky_panel(sky, k, point);
                    ASSERT_TRUE(panel);
                    const auto width = SkyWidth::of(sky, *panel, point, normal);
                    const double lx = illuminance_from(sky, *panel, point, normal).r;
                    const double sum = width ? sum_over_lines(*width, 0, 1) : 0;
                    EXPECT_NEAR(sum, lx, 3e-6 * (lx + 0.01)) << static_cast<int>(model);
                    if (!width) continue;
                    const double parts = sum_over_lines(*width, 0, 0.35) +
                                         sum_over_lines(*width, 0.35, 0.8) +
                                         sum_over_lines(*width, 0.8, 1);
                    EXPECT_NEAR(parts, sum, 1e-7);
                }
            }
        }
    }
}

/// A part of a line is what its rate adds up to over the elevations.
TEST(SkyWidth, LineIsTheIntegralOfItsRate) {
    for (const SkyModel model : models) {
        const SkyLight sky = some_sky(model);
        const Vec3 normal = Vec3(0.3, 0.1, 0.5).normalized();
        const auto width = SkyWidth::of(sky, *sky_panel(sky, 0, Vec3(0)), Vec3(0), normal);
        ASSERT_TRUE(width);
        for (const double place : {-0.9, -0.2, 0.3, 0.8}) {
            const SubAxis axis = width->sub_axis(place);
            double sum = 0;
            for (const ParameterInterval& part : width->elevations(axis))
                sum += integrate_adaptively([&](double t) { return width->light_rate(axis, t); },
                                            part.begin, part.end, 1e-12);
            EXPECT_NEAR(width->lit(axis, 0, 1), sum, 1e-8);
        }
    }
}

/// Light comes in at the window, which fog needs to know, and bodies behind it hide the sky.
TEST(SkyWidth, PanelOfAWindowIsFarAwayInTheSameDirections) {
    SkyLight sky = some_sky(SkyModel::overcast);
    sky.windows = {{{{2000, -900, 300}, {2000, 900, 300}, {2000, 900, 1900}, {2000, -900, 1900}}}};
    const Vec3 point(500, 0, 0), normal(1, 0, 0);
    const auto panel = sky_panel(sky, 0, point);
    ASSERT_TRUE(panel);
    EXPECT_GT(panel->outline.corners[0].x, 1e6);
    const auto width = SkyWidth::of(sky, *panel, point, normal);
    ASSERT_TRUE(width);
    const SubAxis axis = width->sub_axis(0.3);
    for (const ParameterInterval& part : width->elevations(axis))
        EXPECT_NEAR(width->place(axis, part.begin).x, 2000, 1e-6);
    EXPECT_FALSE(sky_panel(sky, 0, {0, 0, 2000})); // below its horizon
    sky.ground = Rgb(1);
    ASSERT_EQ(panel_count(sky), 2);
    EXPECT_TRUE(sky_panel(sky, 1, {0, 0, 2000})->ground);
}

} // namespace
} // namespace keiko
