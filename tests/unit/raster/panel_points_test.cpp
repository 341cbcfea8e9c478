#include "keiko/raster/panel_points.h"

#include "keiko/math/polygon.h"

#include "tests/support/sphere_and_plate.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace keiko {
namespace {

using Outline = std::vector<Vec2>;

/// Outlines with notches, corners in line and a dent that reaches almost through.
const std::vector<Outline>& outlines() {
    static const std::vector<Outline> all{
        {{0, 0}, {40, 0}, {40, 30}, {0, 30}},
        {{0, 0}, {40, 0}, {10, 10}, {0, 40}},
        {{0, 0}, {30, 0}, {60, 0}, {60, 40}, {40, 40}, {40, 10}, {20, 10}, {20, 40}, {0, 40}},
        {{0, 0}, {50, 0}, {50, 30}, {25, 0.01}, {0, 30}},
        {{0, 20}, {15, 15}, {20, 0}, {25, 15}, {40, 20}, {25, 25}, {20, 40}, {15, 25}}};
    return all;
}

/// On a plane that slants.
std::vector<Vec3> in_space(const Outline& outline) {
    std::vector<Vec3> corners;
    for (const Vec2& p : outline)
        corners.push_back(Vec3(5, -3, 50) + Vec3(0.8, 0, 0.6) * p.x + Vec3(0, 1, 0) * p.y);
    return corners;
}

void expect_to_fill(const Outline& outline, const std::vector<EmittingPoint>& points) {
    double area = 0, whole = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
        whole += (a.x * b.y - a.y * b.x) / 2;
    }
    for (const EmittingPoint& point : points) {
        EXPECT_GT(point.area, 0);
        EXPECT_NEAR(point.normal.dot(Vec3(-0.6, 0, 0.8)), 1, 1e-12);
        const Vec3 way = point.position - Vec3(5, -3, 50);
        EXPECT_TRUE(holds(outline, Vec2(way.dot(Vec3(0.8, 0, 0.6)), way.y)));
        area += point.area;
    }
    EXPECT_NEAR(area, whole, 1e-9 * whole);
}

TEST(PanelPoints, FillOutlinesWithNotchesFromAnyCorner) {
    for (Outline outline : outlines())
        for (std::size_t turn = 0; turn < outline.size(); ++turn) {
            expect_to_fill(outline, points_of_panel(in_space(outline), 4));
            std::rotate(outline.begin(), outline.begin() + 1, outline.end());
        }
}

TEST(PanelPoints, AreThirtyTwoOfARectangle) {
    EXPECT_EQ(points_of_panel(in_space(outlines()[0]), 4).size(), 32u);
}

TEST(PanelPoints, FillStarsOfRandomRadii) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> radius(1, 40);
    for (int run = 0; run < 50; ++run) {
        Outline outline;
        for (int i = 0; i < 24; ++i) {
            const double angle = i * 0.2617993877991494;
            outline.push_back(Vec2(std::cos(angle), std::sin(angle)) * radius(random));
        }
        expect_to_fill(outline, points_of_panel(in_space(outline), 2));
    }
}

TEST(PanelPoints, LightNoPixelLessThanNotAtAllOrMoreThanFully) {
    const SurfaceMesh mesh = test::sphere_and_plate(12);
    const Camera camera = test::camera_above();
    const MeshView view(mesh, camera);
    const std::vector<Vec3> corners{Vec3(-100, -90, 90), Vec3(-90, 90, 90), Vec3(-60, -60, 90),
                                    Vec3(90, -80, 90)};
    const Image share =
        lit_pixels(view, ShadowCasters(mesh), points_of_panel(corners, 4), MeshShadows::ray);
    const auto [least, most] = std::minmax_element(share.values.begin(), share.values.end());
    EXPECT_EQ(*least, 0);
    EXPECT_EQ(*most, 1);
}

} // namespace
} // namespace keiko
