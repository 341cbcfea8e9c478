#include "keiko/light/areas/sign.h"

#include "keiko/light/areas/area_coverage.h"
#include "keiko/light/areas/area_irradiance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace keiko {
namespace {

using Ring = std::vector<Vec3>;

Ring rectangle(double x0, double y0, double x1, double y1) {
    return {{x0, y0, 500}, {x0, y1, 500}, {x1, y1, 500}, {x1, y0, 500}}; // shines down
}

/// A panel with an L, a bar and a bar that lies in its shadow from most corners.
LuminousSign sign() {
    LuminousSign sign;
    sign.panel = {rectangle(-400, -300, 400, 300), Rgb(40)};
    const Ring angle{{-300, -200, 500}, {-300, 200, 500}, {-220, 200, 500},
                     {-220, -120, 500}, {-60, -120, 500}, {-60, -200, 500}};
    sign.legend = {{angle, Rgb(400)},
                   {rectangle(20, -250, 60, 250), Rgb(300)},
                   {rectangle(-200, -100, -80, 100), Rgb(200)}};
    return sign;
}

double area_of(const Ring& ring) {
    return polygon_normal(ring).length() / 2;
}

TEST(LuminousSign, PanelKeepsTheAreaAroundItsLegend) {
    const LuminousSign whole = sign();
    const std::vector<PolygonLight> panels = whole.panels();
    ASSERT_EQ(panels.size(), 4U);
    double legend = 0;
    for (std::size_t i = 1; i < 4; ++i) legend += area_of(panels[i].corners);
    EXPECT_NEAR(area_of(panels[0].corners), 800.0 * 600 - legend, 1e-6);
    EXPECT_EQ(panels[0].normal(), Vec3(0, 0, -1));
}

/// Each place of the sign has one luminance: that of a part of the legend or the panel's own.
TEST(LuminousSign, EveryPlaceShowsOnePanel) {
    const LuminousSign whole = sign();
    std::mt19937 random(3);
    std::uniform_real_distribution<double> x(-450, 450), y(-350, 350);
    const std::vector<PolygonLight> panels = whole.panels();
    for (int i = 0; i < 2000; ++i) {
        const Vec3 place(x(random), y(random), 0);
        const auto count = std::count_if(panels.begin(), panels.end(), [&](const auto& panel) {
            return area_hit(PanelOutline(panel), place, {0, 0, 1}, {}).has_value();
        });
        const bool inside = std::abs(place.x) < 400 && std::abs(place.y) < 300;
        EXPECT_EQ(count, inside ? 1 : 0) << place;
        const bool in_legend =
            std::any_of(whole.legend.begin(), whole.legend.end(), [&](const auto& part) {
                return area_hit(PanelOutline(part), place, {0, 0, 1}, {}).has_value();
            });
        EXPECT_EQ(area_hit(PanelOutline(panels[0]), place, {0, 0, 1}, {}).has_value(),
                  inside && !in_legend);
    }
}

/// The cuts of the ring cancel: the light is that of the whole panel less that of the holes.
TEST(LuminousSign, PanelLightsAsItsPartsDo) {
    const LuminousSign whole = sign();
    const std::vector<PolygonLight> panels = whole.panels();
    std::mt19937 random(5);
    std::uniform_real_distribution<double> x(-600, 600), z(-400, 450), tilt(-1, 1);
    for (int i = 0; i < 200; ++i) {
        const Vec3 point(x(random), x(random), z(random));
        const Vec3 normal = Vec3(tilt(random), tilt(random), 1).normalized();
        double rest = projected_solid_angle(whole.panel, point, normal);
        for (const PolygonLight& part : whole.legend)
            rest -= projected_solid_angle(part, point, normal);
        EXPECT_NEAR(projected_solid_angle(panels[0], point, normal), rest, 1e-12);
    }
}

TEST(LuminousSign, LuminanceOfTheLegendIsThatOfItsAreaInTheMean) {
    const LuminousSign whole = sign();
    const double angle = 80.0 * 400 + 160 * 80, bar = 40.0 * 500, block = 120.0 * 200;
    EXPECT_NEAR(whole.legend_luminance(),
                (400 * angle + 300 * bar + 200 * block) / (angle + bar + block), 1e-9);
    LuminousSign blank = whole;
    blank.legend.clear();
    EXPECT_NEAR(blank.legend_luminance(), 40, 1e-12);
    EXPECT_EQ(blank.panels().size(), 1U);
}

/// A ring of holes around a hole: cuts pass between them.
TEST(LuminousSign, ManyHolesAreCutOut) {
    std::vector<Ring> holes;
    double cut = 0;
    for (int i = 0; i < 7; ++i)
        for (int k = 0; k < 7; ++k) {
            const double x = -350 + 100.0 * i, y = -260 + 80.0 * k;
            holes.push_back(rectangle(x, y, x + 60 + i, y + 30 + k));
            cut += area_of(holes.back());
            if ((i + k) % 2 == 0) std::reverse(holes.back().begin(), holes.back().end());
        }
    EXPECT_NEAR(area_of(without_holes(rectangle(-400, -300, 400, 300), holes)), 800.0 * 600 - cut,
                1e-6);
}

} // namespace
} // namespace keiko
