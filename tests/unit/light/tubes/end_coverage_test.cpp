#include "keiko/light/tubes/end_coverage.h"

#include "keiko/light/tubes/c_plane_lookup.h"
#include "keiko/light/tubes/stripe_coverage.h"

#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace keiko;

namespace {

constexpr double diameter = 30, pitch = 100, length = 1000, height = 2000;

CPlaneFrame row() {
    CPlane plane;
    plane.origin = {0, 0, height};
    plane.u = {length, 0, 0};
    plane.v = {0, 5 * pitch, 0};
    plane.lamps = 5;
    plane.pitch = pitch;
    plane.diameter = diameter;
    return CPlaneFrame(plane);
}

const LampEnds ends = LampEnds::straight(row());

/// A pixel's rays, which change linearly over it.
struct Rays {
    Vec3 origin, direction;
    RayDifferentials spread;

    Footprint image(const CPlaneFrame& frame) const {
        return footprint_on(frame, *c_plane_coordinates(frame, origin, direction), spread);
    }
    Vec2 centre(const CPlaneFrame& frame) const {
        const auto hit = c_plane_coordinates(frame, origin, direction);
        return {hit->u, hit->v};
    }
};

/// Coverage of the pixel, by a grid of its rays.
double sampled(const CPlaneFrame& frame, const Rays& rays, int side) {
    int lit = 0;
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            const double x = (i + 0.5) / side - 0.5, y = (j + 0.5) / side - 0.5;
            const RayDifferentials& s = rays.spread;
            const auto hit =
                c_plane_coordinates(frame, rays.origin + s.origin_dx * x + s.origin_dy * y,
                                    rays.direction + s.direction_dx * x + s.direction_dy * y);
            lit += hit && strip_at(frame, hit->u, hit->v, diameter) ? 1 : 0;
        }
    return lit / static_cast<double>(side * side);
}

double end_coverage_of(const CPlaneFrame& frame, const Rays& rays) {
    return end_coverage(frame, diameter, true, ends, rays.centre(frame), rays.image(frame));
}

/// Rays from one place to one end of the lamps or the other, from near to so wide that the plane's
/// horizon runs through the pixel.
Rays any_rays(test::Random& random) {
    const Vec3 end(test::pick(random, 2) ? length : 0, test::uniform(random, 0, 5 * pitch), height);
    const Vec3 from(test::uniform(random, -9000, 9000), test::uniform(random, -9000, 9000),
                    test::uniform(random, -200, 1900));
    const Vec3 to = end + test::random_direction(random) * 60 - from;
    const double width = std::pow(10, test::uniform(random, -2, 0.3));
    const Vec3 direction = to / to.length();
    return {from,
            direction,
            {Vec3(0), Vec3(0), test::random_direction(random) * width,
             test::random_direction(random) * width}};
}

} // namespace

// Rays from one place are the case in which the image is what it is taken for: exact, though no
// parallelogram.
TEST(EndCoverage, IsTheShareOfRaysThatMeetLamps) {
    test::Random random(7);
    const CPlaneFrame frame = row();
    int lit = 0, horizons = 0;
    double product_off = 0;
    for (int trial = 0; trial < 300; ++trial) {
        const Rays rays = any_rays(random);
        const auto hit = c_plane_coordinates(frame, rays.origin, rays.direction);
        if (!hit) continue;
        const Footprint image = rays.image(frame);
        const double found = end_coverage_of(frame, rays), truth = sampled(frame, rays, 400);
        EXPECT_NEAR(found, truth, 0.01) << trial; // a few rows of the grid
        lit += truth > 0.02, horizons += !std::isfinite(image.reach_along());
        const PixelFilter along(image.dx.x, image.dy.x), across(image.dx.y, image.dy.y);
        const double product = along.share(-hit->u, length - hit->u) *
                               comb_coverage(frame, true, diameter, hit->v, across);
        product_off = std::max(product_off, std::abs(product - truth));
    }
    EXPECT_GT(lit, 60);
    EXPECT_GT(horizons, 20);
    EXPECT_GT(product_off, 0.1);
}

// Rays from a curved mirror, whose origins move too: what is left out is their product with the
// turn of the rays. Parallelograms in the place of the images would be far off.
TEST(EndCoverage, IsNearForRaysFromMovingPlaces) {
    const CPlaneFrame frame = row();
    double off = 0, of_parallelograms = 0;
    for (int k = 0; k < 24; ++k) {
        const Vec3 end(length, 250 + 10.0 * k, height), from(2500 + 90.0 * k, -700, 300);
        const Rays rays{
            from,
            end - from,
            {Vec3(120, 18, 60), Vec3(-30, 120, 10), Vec3(260, 700, 700), Vec3(-300, 180, -280)}};
        const double truth = sampled(frame, rays, 400);
        off = std::max(off, std::abs(end_coverage_of(frame, rays) - truth));
        Footprint image = rays.image(frame);
        image.descent = Vec2(0);
        const double flat = end_coverage(frame, diameter, true, ends, rays.centre(frame), image);
        of_parallelograms = std::max(of_parallelograms, std::abs(flat - truth));
    }
    EXPECT_LT(off, 0.004);
    EXPECT_GT(of_parallelograms, 5 * off);
}

// An upright box: the shares along and across have nothing to do with each other.
TEST(EndCoverage, IsTheProductForUprightImages) {
    test::Random random(8);
    const CPlaneFrame frame = row();
    for (int trial = 0; trial < 200; ++trial) {
        const Vec2 centre(test::uniform(random, -80, 80), test::uniform(random, -50, 550));
        const double du = test::uniform(random, 1, 150), dv = test::uniform(random, 1, 300);
        const PixelFilter along(du, 0), across(0, dv);
        const double share = along.share(-centre.x, length - centre.x);
        const Footprint box = Footprint::box(du, dv);
        for (const double width : {diameter, 1.5 * pitch})
            EXPECT_NEAR(end_coverage(frame, width, true, ends, centre, box),
                        share * comb_coverage(frame, true, width, centre.y, across), 1e-12);
        EXPECT_NEAR(end_coverage(frame, diameter, false, ends, centre, box),
                    share * mean_coverage(frame, diameter, centre.y, across), 1e-12);
    }
}

// From one lamp that is cut to one that the pixel does not reach, in a line without an area.
TEST(EndCoverage, OfALineIsTheShareOfItsLength) {
    const CPlaneFrame frame = row();
    const Footprint line{{200, 0}, {0, 0}};
    EXPECT_NEAR(end_coverage(frame, diameter, true, ends, {-20, frame.axis(2)}, line), 0.4, 1e-12);
    EXPECT_EQ(end_coverage(frame, diameter, true, ends, {-20, frame.axis(2) + pitch / 2}, line), 0);
}

TEST(EndCoverage, OfNoNumbersIsDark) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    const Footprint image{{none, 50}, {4, none}, {none, 0}};
    EXPECT_EQ(end_coverage(row(), diameter, true, ends, {0, 250}, image), 0);
}

// What a pixel sees that looks beyond the ends is what its places see, also where its image is
// slanted so that the shares along and across say otherwise.
TEST(EndCoverage, LightsNoPixelWhoseImageMissesTheLamps) {
    const CPlaneFrame frame = row();
    // From beside the ends, at the height of a strip, to between two strips before the ends.
    const Footprint image{{-60, 50}, {4, 4}};
    const Vec2 centre(-20, frame.axis(2) - 25);
    const Vec3 under = frame.at(centre.x, centre.y) - frame.normal * 500.0;
    const Rays rays{under, frame.normal, {Vec3(-60, 50, 0), Vec3(4, 4, 0), Vec3(0), Vec3(0)}};
    const double truth = sampled(frame, rays, 800);
    EXPECT_NEAR(look_up(frame, under, frame.normal, image, MirrorModel::flat).coverage, truth,
                4e-3);
    const PixelFilter along(-60, 4), across(50, 4);
    EXPECT_GT(along.share(20, length) * comb_coverage(frame, true, diameter, centre.y, across),
              truth + 0.049);
}

// The horizon runs beside the pixel's centre, whose ray is far from all lamps: half of the pixel
// sees the plane, and the lamps near its border.
TEST(EndCoverage, EndsAtThePlanesHorizon) {
    const CPlaneFrame frame = row();
    const Rays rays{
        {500, -2000, 0}, {0, 1, 0.1}, {Vec3(0), Vec3(0), Vec3(0.3, 0, 0), Vec3(0, 0, 2)}};
    const Footprint image = rays.image(frame);
    EXPECT_TRUE(std::isinf(image.reach_along()));
    EXPECT_GT(rays.centre(frame).y, 10000);
    const double found =
        look_up(frame, rays.origin, rays.direction, image, MirrorModel::flat).coverage;
    EXPECT_NEAR(found, sampled(frame, rays, 800), 2e-3);
    EXPECT_GT(found, 0.02);
}

// Few strips, far apart, that go on to their vanishing point in the pixel. The truth: each strip by
// itself, as a plane of one wide lamp, for which no range of strips is looked for.
TEST(EndCoverage, CountsResolvedStripsUpToTheHorizon) {
    test::Random random(5);
    CPlane plane;
    plane.origin = {0, 0, 2000};
    plane.u = {length, 0, 0};
    plane.v = {0, 500, 0};
    plane.lamps = 5, plane.pitch = pitch, plane.diameter = diameter;
    const CPlaneFrame frame(plane);
    plane.lamps = 1, plane.pitch = plane.diameter = 20;
    const CPlaneFrame one(plane);
    int lit = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        const auto any = [&](double least, double most) {
            return test::uniform(random, least, most);
        };
        const Vec3 from(any(100, 900), any(-6000, 200), any(0, 1900));
        const Vec3 direction(any(-0.1, 0.1), trial % 2 ? 1 : -1, any(0.0005, 0.2));
        const double size = any(0.05, 0.6);
        const RayDifferentials differentials{Vec3(0), Vec3(0),
                                             Vec3(size * any(0.3, 1), 0, size * any(-1, 1)),
                                             Vec3(size * any(-0.3, 0.3), 0, size)};
        const auto hit = c_plane_coordinates(frame, from, direction);
        if (!hit) continue;
        const Footprint image = footprint_on(frame, *hit, differentials);
        double sum = 0;
        for (int i = 0; i < frame.lamps; ++i) {
            const Vec2 centre(hit->u, hit->v - frame.axis(i) + one.axis(0));
            sum += end_coverage(one, diameter, true, ends, centre, image);
        }
        EXPECT_NEAR(end_coverage(frame, diameter, true, ends, {hit->u, hit->v}, image), sum, 1e-9);
        lit += sum > 0.01 ? 1 : 0;
    }
    EXPECT_GT(lit, 500);
}
