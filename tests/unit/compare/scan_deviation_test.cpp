#include "keiko/compare/scan/scan_deviation.h"

#include "keiko/compare/scan/scan_map.h"

#include "tests/support/analytic_models.h"
#include "tests/support/model_builder.h"
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

using test::ModelBuilder;

/// 100 x 100 mm at height 0, its outside upwards.
SurfaceModel plate() {
    ModelBuilder builder;
    builder.plane({0, 0, 0}, {100, 0, 0}, {0, 100, 0});
    return builder.build();
}

/// The plate with a wall down from its border at x = 100.
SurfaceModel bracket() {
    ModelBuilder builder;
    builder.plane({0, 0, 0}, {100, 0, 0}, {0, 100, 0});
    builder.plane({100, 0, 0}, {0, 0, -100}, {0, 100, 0});
    return builder.build();
}

ClosestPointQuery query_of(const SurfaceModel& model) {
    return ClosestPointQuery(placed_model(model));
}

/// A grid over the plate whose points lie `height(x, y)` above it.
template <class Height>
std::vector<Vec3> points_over_plate(int count, const Height& height) {
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i)
        for (int j = 0; j < count; ++j) {
            const double x = 100 * (i + 0.5) / count, y = 100 * (j + 0.5) / count;
            points.emplace_back(x, y, height(x, y));
        }
    return points;
}

/// Directions spread over the sphere.
std::vector<Vec3> directions(int count) {
    std::vector<Vec3> all;
    for (int i = 0; i < count; ++i) {
        const double z = 1 - 2 * (i + 0.5) / count, turn = 2.399963 * i;
        const double r = std::sqrt(1 - z * z);
        all.emplace_back(r * std::cos(turn), r * std::sin(turn), z);
    }
    return all;
}

TEST(ScanDeviation, IsTheRadialOffsetOfASphereToRounding) {
    const ClosestPointQuery sphere = query_of(test::sphere_model(Affine::scale(50)));
    const auto offset = [](const Vec3& d) { return 0.3 * d.z * d.x - 0.05; };
    std::vector<Vec3> points;
    for (const Vec3& d : directions(2000)) points.push_back(d * (50 + offset(d)));
    const auto found = point_deviations(points, {}, sphere);
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_NEAR(found[i].distance, offset(points[i].normalized()), 1e-9);
        EXPECT_TRUE(found[i].is_measured());
        EXPECT_TRUE(found[i].certain);
    }
}

TEST(ScanDeviation, CountsAPlantedDentInClosedForm) {
    // A dent z = -0.4 (1 - r^2 / 20^2) is deeper than 0.1 mm within r = 20 sqrt(3/4).
    const auto height = [](double x, double y) {
        const double square = ((x - 50) * (x - 50) + (y - 50) * (y - 50)) / 400;
        return square < 1 ? -0.4 * (1 - square) : 0.0;
    };
    const auto points = point_deviations(points_over_plate(200, height), {}, query_of(plate()));
    const ScanDeviation d = scan_deviation(points, 1, 0.1);
    std::size_t out = 0;
    for (const Vec3& p : points_over_plate(200, height)) out += p.z < -0.1;
    EXPECT_EQ(d.measured, 40000u);
    EXPECT_DOUBLE_EQ(*d.within, 1 - static_cast<double>(out) / 40000);
    const double area_out = std::numbers::pi * 300 / 10000,
                 volume = 0.4 * std::numbers::pi * 400 / 2;
    EXPECT_NEAR(*d.within, 1 - area_out, 1e-3); // but for some points along the circle
    EXPECT_NEAR(d.mean, -volume / 10000, 1e-5);
    EXPECT_NEAR(d.lowest.value, -0.4, 1e-3);
    EXPECT_NEAR(d.highest.value, 0, 1e-12);
    EXPECT_NEAR((d.lowest.place - Vec3(50, 50, 0)).length(), 0, 0.5);
    EXPECT_EQ(d.faces[0].within, 40000 - out);
}

TEST(ScanDeviation, HasTheToleranceAsAnEdgeOfTheHistogram) {
    std::vector<PointDeviation> points;
    for (int i = -200; i < 200; ++i) points.push_back({.distance = (i + 0.5) / 1000, .face = 0});
    const DeviationHistogram h = scan_deviation(points, 1, 0.05).histogram;
    EXPECT_DOUBLE_EQ(h.width, 0.01);
    EXPECT_DOUBLE_EQ(h.lowest, -0.2);
    ASSERT_EQ(h.counts.size(), 40u);
    for (const std::size_t count : h.counts) EXPECT_EQ(count, 10u);
}

TEST(ScanDeviation, KeepsWhatIsBeyondTheLastBinInIt) {
    std::vector<PointDeviation> points(5000, {.distance = 0.01, .face = 0});
    points[0].distance = 40, points[1].distance = -40;
    const DeviationHistogram h = scan_deviation(points, 1, 0.05).histogram;
    EXPECT_EQ(h.counts.front(), 1u);
    EXPECT_EQ(h.counts.back(), 1u);
    std::size_t sum = 0;
    for (const std::size_t count : h.counts) sum += count;
    EXPECT_EQ(sum, 5000u);
}

TEST(ScanDeviation, LeavesOutWhatLiesBeyondFreeBorders) {
    const std::vector<Vec3> points{{50, 50, 0.2}, {-3, 50, 0.1}, {50, 103, 0}, {50, 50, 30}};
    const auto found = point_deviations(points, {}, query_of(plate()), {.reach = 10});
    EXPECT_FALSE(found[0].beside);
    EXPECT_TRUE(found[1].beside);
    EXPECT_TRUE(found[2].beside);
    EXPECT_TRUE(std::isinf(found[3].distance));
    const ScanDeviation d = scan_deviation(found, 1, 0.3);
    EXPECT_EQ(d.measured, 1u);
    EXPECT_EQ(d.beside, 2u);
    EXPECT_EQ(d.beyond, 1u);
    EXPECT_EQ(*d.within, 0.5); // what is beyond reach is outside of the tolerance
}

TEST(ScanDeviation, CountsPointsOffAnEdgeThatTwoFacesShare) {
    const std::vector<Vec3> points{{100.3, 50, 0.3}};
    const auto found = point_deviations(points, {}, query_of(bracket()));
    EXPECT_FALSE(found[0].beside);
    EXPECT_NEAR(found[0].distance, 0.3 * std::numbers::sqrt2, 1e-9);
}

TEST(ScanDeviation, IsTheSameForAnyNumberOfThreads) {
    const ClosestPointQuery sphere = query_of(test::sphere_model(Affine::scale(50)));
    std::vector<Vec3> points;
    for (const Vec3& d : directions(5000)) points.push_back(d * (50 + 0.2 * d.y));
    const auto one = point_deviations(points, {}, sphere, {}, {.threads = 1});
    const auto three = point_deviations(points, {}, sphere, {}, {.threads = 3});
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_EQ(one[i].distance, three[i].distance);
        EXPECT_EQ(one[i].closest, three[i].closest);
    }
}

TEST(ScanMap, HasTheMeanOfThePointsAroundAPixel) {
    const SurfaceModel model = plate();
    const auto points = point_deviations(
        points_over_plate(100, [](double x, double) { return x < 40 ? 0.25 : -0.5; }), {},
        query_of(model));
    Camera camera;
    camera.projection = Projection::orthographic;
    camera.eye = {50, 50, 500}, camera.target = {50, 50, 0}, camera.up = {0, 1, 0};
    camera.orthographic_height = 120, camera.width = camera.height = 60;
    const Tracer tracer(model);
    const double radius = map_radius(points, 141);
    EXPECT_NEAR(radius, 1.5, 0.5); // 1.5 times their spacing of 1 mm
    const DeviationMap map = scan_map(tracer, camera, points, radius);
    EXPECT_TRUE(std::isnan(*map.distance.pixel(1, 30))); // beside the plate
    EXPECT_FLOAT_EQ(*map.distance.pixel(15, 30), 0.25f);
    EXPECT_FLOAT_EQ(*map.distance.pixel(45, 30), -0.5f);
    const DeviationMap empty = scan_map(tracer, camera, {}, radius);
    EXPECT_TRUE(std::isnan(*empty.distance.pixel(15, 30)));
    EXPECT_GT(*empty.facing.pixel(15, 30), 0.9f);
}

} // namespace
} // namespace keiko
