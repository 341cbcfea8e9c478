#include "keiko/intersect/hit/reflect_ray.h"
#include "keiko/render/reflection/reflected_grid.h"

#include "tests/unit/render/stage.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

using namespace keiko;
using test::dome;
using test::Stage;

namespace {

/// Reflected ray at a place of the picture; `size`: of the pixel.
Ray mirrored(const Stage& stage, double x, double y, double size) {
    Ray eye = stage.camera.ray(x, y);
    eye.differentials = eye.differentials->scaled(size);
    return reflect_ray(eye, stage.tracer.nearest(eye).value());
}

PixelRay pixel_ray(const Ray& ray) {
    return {ray.origin, ray.direction, ray.differentials.value()};
}

/// The reflected rays of a pixel and its neighbours.
struct Around {
    Ray centre, left, right, above, below;

    Around(const Stage& stage, double x, double y, double size)
        : centre(mirrored(stage, x, y, size)),
          left(mirrored(stage, x - size, y, size)),
          right(mirrored(stage, x + size, y, size)),
          above(mirrored(stage, x, y - size, size)),
          below(mirrored(stage, x, y + size, size)) {}

    PixelRays rays() const {
        return {pixel_ray(centre), pixel_ray(left), pixel_ray(right), pixel_ray(above),
                pixel_ray(below)};
    }
};

ReflectedFootprint pixel_at(const Stage& stage, double x, double y, double size) {
    return ReflectedFootprint(Around(stage, x, y, size).rays());
}

/// Between directions to a corner of a pixel: as the cubic tells it and as it is.
double error_of(const Stage& stage, double size) {
    const PixelRay told = pixel_at(stage, 48, 27, size).part(0.5, -0.5, 1);
    const Ray is = mirrored(stage, 48 + 0.5 * size, 27 - 0.5 * size, size);
    return (told.direction - is.direction).length() + (told.origin - is.origin).length() / 3000;
}

double linear_error_of(const Stage& stage, double size) {
    const Ray centre = mirrored(stage, 48, 27, size);
    const Ray is = mirrored(stage, 48 + 0.5 * size, 27 - 0.5 * size, size);
    const Vec3 told =
        centre.direction +
        (centre.differentials->direction_dx - centre.differentials->direction_dy) * 0.5;
    return (told - is.direction).length();
}

/// Stripes at a pixel: mean over many points of it.
double sampled(const Stage& stage, double x, double y, double size) {
    constexpr int n = 96;
    double sum = 0;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const Ray ray = mirrored(stage, x + ((i + 0.5) / n - 0.5) * size,
                                     y + ((j + 0.5) / n - 0.5) * size, size);
            sum += RigPlanes(stage.rig).luminance(ray.origin, ray.direction).coverage;
        }
    return sum / (n * n);
}

/// How far large pixels of the stage's picture are off the mean over many points, at the most: by
/// their bent images, and by straight ones.
struct Errors {
    double bent = 0, straight = 0;
    int pixels_with_borders = 0; ///< of lamps

    explicit Errors(const Stage& stage) {
        constexpr double size = 6;
        for (const double x : {30.0, 38.0, 46.0, 54.0, 62.0})
            for (const double y : {24.0, 30.0, 36.0}) {
                const Around around(stage, x, y, size);
                const double truth = sampled(stage, x, y, size);
                const auto off = [&](const std::optional<PixelRays>& rays) {
                    const PixelMirror seen = mirror_of(RigPlanes(stage.rig), around.centre, rays,
                                                       around.centre.t_max, false);
                    return std::abs(seen.lamps.coverage - truth);
                };
                bent = std::max(bent, off(around.rays()));
                straight = std::max(straight, off({}));
                pixels_with_borders += truth > 0.1 && truth < 0.9;
            }
    }
};

} // namespace

TEST(ReflectedFootprint, IsRightToTheFourthOrder) {
    const Stage stage(dome());
    for (const double size : {4.0, 2.0, 1.0}) {
        EXPECT_LT(error_of(stage, size / 2), error_of(stage, size) / 10) << size;
        EXPECT_LT(error_of(stage, size), 0.1 * linear_error_of(stage, size)) << size;
    }
}

TEST(ReflectedFootprint, TellsTheDifferentialsOfItsParts) {
    const Stage stage(dome());
    const PixelRay told = pixel_at(stage, 40, 30, 1).part(0.25, 0.25, 0.5);
    const Ray is = mirrored(stage, 40.25, 30.25, 0.5);
    const Vec3 off = told.spread.direction_dx - is.differentials->direction_dx;
    EXPECT_LT(off.length(), 1e-4 * is.differentials->direction_dx.length());
    const Vec3 moved = told.spread.origin_dy - is.differentials->origin_dy;
    EXPECT_LT(moved.length(), 1e-4 * is.differentials->origin_dy.length());
}

// Pixels so large that their images on the lamps' plane are bent by a good part of the pitch.
TEST(ReflectedFootprint, SeesStripesWhereItsImageIsBent) {
    const Stage stage(dome());
    const Errors errors(stage);
    EXPECT_LT(errors.bent, 0.02);
    EXPECT_GT(errors.straight, 3 * errors.bent);
}

// Lamps so far apart that images count as straight across them, and so short that they end within.
TEST(ReflectedFootprint, SeesEndsOfLampsWhereItsImageIsBent) {
    Stage stage(dome());
    CPlane& plane = std::get<CPlane>(stage.rig.sources[0]);
    plane.origin = {-600, 500, 2000};
    plane.u = {800, 300, 0};
    plane.v = {-2400, 6400, 0};
    plane.lamps = 2;
    plane.diameter = 2400;
    plane.mirror = MirrorModel::flat;
    const Errors errors(stage);
    EXPECT_GT(errors.pixels_with_borders, 3);
    EXPECT_LT(errors.bent, 0.01);
    EXPECT_GT(errors.straight, 3 * errors.bent);
}

TEST(ReflectedFootprint, IsPartedTheFinerTheMoreItsImageIsBent) {
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(parts_of_bend(0), 1);
    EXPECT_EQ(parts_of_bend(straight_image), 1);
    EXPECT_EQ(parts_of_bend(4 * straight_image), 2);
    EXPECT_EQ(parts_of_bend(4.001 * straight_image), 3);
    for (const double far : {64 * straight_image, 1e300, infinity, std::nan("")})
        EXPECT_EQ(parts_of_bend(far), 8);
}

// Random differentials, of one pixel in four with as much difference as the signs allow.
TEST(ReflectedFootprint, KeepsItsPartsWithinItsBundle) {
    std::mt19937_64 engine(20261122);
    std::uniform_real_distribution<double> between(-1, 1);
    double nearest = 0;
    for (int trial = 0; trial < 4000; ++trial) {
        const auto number = [&] {
            const double x = between(engine);
            return trial % 4 == 0 ? std::copysign(1.0, x) : x;
        };
        const auto vector = [&] { return Vec3(number(), 0.1 * number(), 0.1 * number()); };
        std::array<PixelRay, 5> rays;
        for (PixelRay& ray : rays)
            ray = {Vec3(0), Vec3(0), {vector(), vector(), vector(), vector()}};
        const PixelRays pixel{rays[0], rays[1], rays[2], rays[3], rays[4]};
        const RayCone bundle = cone_of(pixel);
        for (const double y : {-0.5, -0.2, 0.5})
            for (const double x : {-0.5, 0.1, 0.5}) {
                const PixelRay part = ReflectedFootprint(pixel).part(x, y, 1);
                const RayDifferentials& s = bundle.spread;
                const Vec3 origin = part.origin - s.origin_dx * x - s.origin_dy * y;
                const Vec3 direction = part.direction - s.direction_dx * x - s.direction_dy * y;
                const double off = (direction - bundle.direction).length();
                EXPECT_LE((origin - bundle.origin).length(), bundle.origin_rest);
                EXPECT_LE(off, bundle.direction_rest);
                EXPECT_LE((part.spread.origin_dx - s.origin_dx).length(), bundle.origin_slope_rest);
                EXPECT_LE((part.spread.direction_dy - s.direction_dy).length(),
                          bundle.direction_slope_rest);
                nearest = std::max(nearest, off / bundle.direction_rest);
            }
    }
    EXPECT_GT(nearest, 0.45); // the bound is no idle one
}

TEST(ReflectedGrid, HasPixelsWhereFourNeighboursShowTheSame) {
    const Stage stage(dome());
    std::vector<SurfacePlace> places;
    std::vector<Ray> rays(9);
    for (std::size_t i = 0; i < 9; ++i) {
        const double x = 47 + static_cast<double>(i % 3), y = 26 + static_cast<double>(i / 3);
        const auto hit = stage.tracer.nearest(stage.camera.ray(x, y));
        places.push_back({hit->position, hit->normal, i == 5 ? 1u : 0u});
        rays[i] = mirrored(stage, x, y, 1);
    }
    const auto middle = [&] {
        ReflectedGrid grid(3, 3);
        for (std::size_t i = 0; i < 9; ++i) {
            grid.set_begin(i, places[i]);
            grid.set(i, rays[i]);
        }
        grid.join();
        EXPECT_FALSE(grid.around(0));
        EXPECT_FALSE(grid.around(8));
        return grid.around(4).has_value();
    };
    EXPECT_FALSE(middle()); // its right neighbour is of another paint
    places[5].paint = 0;
    EXPECT_TRUE(middle());
    rays[1].differentials.reset();
    EXPECT_FALSE(middle());
}

TEST(ReflectedGrid, KeepsRaysToTheBit) {
    const Stage stage(dome());
    ReflectedGrid grid(2, 1);
    const Ray ray = mirrored(stage, 47, 26, 1);
    Ray line = ray;
    line.differentials.reset();
    grid.set(0, ray), grid.set(1, line);
    for (const std::size_t place : {0, 1}) {
        EXPECT_EQ(grid.ray(place).origin, ray.origin);
        EXPECT_EQ(grid.ray(place).direction, ray.direction);
    }
    EXPECT_FALSE(grid.ray(1).differentials);
    const RayDifferentials is = grid.ray(0).differentials.value();
    const RayDifferentials& was = *ray.differentials;
    EXPECT_EQ(is.origin_dx, was.origin_dx);
    EXPECT_EQ(is.origin_dy, was.origin_dy);
    EXPECT_EQ(is.direction_dx, was.direction_dx);
    EXPECT_EQ(is.direction_dy, was.direction_dy);
}
