// What a pixel sees of round tubes at the ends of a row, held against its rays one by one.
#include "keiko/light/tubes/c_plane_lookup.h"
#include "keiko/light/tubes/end_coverage.h"
#include "keiko/light/tubes/tube_hit.h"

#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace keiko;

namespace {

/// A row of five under which all begins at z = 0.
CPlaneFrame row_of(double diameter, double pitch, bool luminous_caps, double length = 1200) {
    CPlane plane;
    plane.origin = {0, 0, 2000};
    plane.u = {length, 0, 0};
    plane.v = {0, 6 * pitch, 0};
    plane.lamps = 5, plane.pitch = pitch, plane.diameter = diameter;
    plane.luminous_caps = luminous_caps;
    return CPlaneFrame(plane);
}

/// A pixel around a ray.
struct Pixel {
    Vec3 origin, direction;
    RayDifferentials spread;

    double seen(const CPlaneFrame& frame) const {
        const auto hit = c_plane_coordinates(frame, origin, direction);
        return look_up(frame, *hit, origin, direction, footprint_on(frame, *hit, spread),
                       MirrorModel::tube)
            .coverage;
    }
    /// The share of a grid of its rays that enter a tube where it shines.
    double truth(const CPlaneFrame& frame, int side = 100) const {
        int lit = 0;
        for (int j = 0; j < side; ++j)
            for (int i = 0; i < side; ++i) {
                const double x = (i + 0.5) / side - 0.5, y = (j + 0.5) / side - 0.5;
                const auto tube =
                    nearest_tube(frame, origin + spread.origin_dx * x + spread.origin_dy * y,
                                 direction + spread.direction_dx * x + spread.direction_dy * y);
                lit += tube && (!tube->cap || frame.luminous_caps) ? 1 : 0;
            }
        return lit / static_cast<double>(side * side);
    }
};

Vec3 across_the_plane(test::Random& random, double size) {
    return Vec3(test::uniform(random, -1, 1), test::uniform(random, -1, 1), 0) * size;
}

/// Random pixel of parallel rays, around the end of a lamp; `size` of it in diameters.
Pixel any_pixel(test::Random& random, const CPlaneFrame& frame, const Vec3& direction,
                double size) {
    const double mm = size * frame.diameter;
    const double room = end_room(frame, direction) + mm / 2;
    const double end = test::pick(random, 2) ? frame.length : 0;
    const double u = end + test::uniform(random, -1, 1) * room;
    const double aside =
        test::uniform(random, -0.6, 0.6) * apparent_diameter(frame, frame.vector(direction));
    const double v = frame.axis(static_cast<int>(test::pick(random, 5))) + aside;
    return {frame.at(u, v) - direction * 2000,
            direction,
            {across_the_plane(random, mm), across_the_plane(random, mm), Vec3(0), Vec3(0)}};
}

/// The most that pixels are off, and how many see a lamp's end.
struct Errors {
    double most = 0;
    int at_ends = 0;

    void add(double is, double truth) {
        most = std::max(most, std::abs(is - truth));
        at_ends += truth > 0.02 && truth < 0.98;
    }
};

/// Errors for rows whose lamps look apart, or as if they overlapped.
Errors errors(double diameter, double size, bool luminous_caps, bool overlap) {
    test::Random random(17);
    Errors errors;
    for (int trial = 0; trial < 60; ++trial) {
        const double sideways =
            overlap ? test::uniform(random, 1.5, 6) : test::uniform(random, 0, 2);
        const Vec3 direction(test::uniform(random, -3, 3), trial % 2 ? sideways : -sideways, 1);
        const double looks = std::hypot(sideways, 1); // wide, in diameters
        const double pitch = diameter * (overlap ? 0.5 + looks / 2 : looks * 1.5);
        const CPlaneFrame frame = row_of(diameter, pitch, luminous_caps);
        const Pixel pixel = any_pixel(random, frame, direction, size);
        errors.add(pixel.seen(frame), pixel.truth(frame));
    }
    return errors;
}

} // namespace

TEST(LampEnds, AreSeenAsRaysMeetThemFromAnySlant) {
    for (const double diameter : {16, 26, 38, 60, 150})
        for (const double size : {0.1, 0.5, 2.0, 6.0})
            for (const bool luminous_caps : {false, true})
                for (const bool overlap : {false, true}) {
                    const Errors off = errors(diameter, size, luminous_caps, overlap);
                    EXPECT_LT(off.most, 0.01) << diameter << " mm, pixels of " << size << ", caps "
                                              << luminous_caps << ", overlap " << overlap;
                    EXPECT_GT(off.at_ends, 5);
                }
}

// Lamps side by side. One may look to begin where its neighbour has ended, or to lie behind the
// next one except for a part of a rim.
TEST(LampEnds, OfClosedRowsAreSeenPastTheLampsBefore) {
    for (const double diameter : {16, 60, 200})
        for (const double length : {20, 30, 60, 200})
            for (const bool luminous_caps : {false, true}) {
                test::Random random(19);
                Errors off;
                for (int trial = 0; trial < 60; ++trial) {
                    const double along = std::pow(10, test::uniform(random, -1, 0.8));
                    const double sideways = std::pow(10, test::uniform(random, -0.5, 1));
                    const double looks = std::hypot(sideways, 1); // wide, in diameters
                    const double pitch = diameter * test::uniform(random, 1, looks);
                    const CPlaneFrame frame = row_of(diameter, pitch, luminous_caps, length);
                    const Vec3 direction(trial % 4 < 2 ? along : -along,
                                         trial % 2 ? sideways : -sideways, 1);
                    const Pixel pixel = any_pixel(random, frame, direction, 0.2 + trial / 4 % 4);
                    off.add(pixel.seen(frame), pixel.truth(frame, 200));
                }
                EXPECT_LT(off.most, 0.005)
                    << diameter << " mm, " << length << " mm long, caps " << luminous_caps;
                EXPECT_GT(off.at_ends, 5);
            }
}

// What chords leave of a rim is much of a pixel that lies along it and is thin.
TEST(LampEnds, AreSeenInSliversAlongThem) {
    CPlane plane;
    plane.origin = {0, 0, 2000};
    plane.u = {60, 0, 0}, plane.v = {0, 120, 0};
    plane.lamps = 2, plane.diameter = 60;
    const CPlaneFrame frame(plane);
    const Vec3 direction(2.85, 0.4, 1);
    for (const double aside : {-6, -3, 0, 3, 6}) {
        const Pixel pixel{frame.at(127.5 + aside, 30.6) - direction * 2000,
                          direction,
                          {Vec3(-43.6, -45.7, 0), Vec3(49.7, 47.1, 0), Vec3(0), Vec3(0)}};
        EXPECT_NEAR(pixel.seen(frame), pixel.truth(frame, 400), 0.004) << aside;
    }
}

// Rays from one eye, low along thick tubes: over a pixel the place where a rim is seen moves by
// several hundredths of the pixel, which holds it on any side of its centre.
TEST(LampEnds, AreSeenByTheRaysOfAPixelThatMeetThem) {
    const CPlaneFrame frame = row_of(200, 200, false, 900);
    const double low = std::sin(0.17), far = std::cos(0.17), size = 0.0044;
    for (const double sign : {-1, 1})
        for (double u = -1600; u < 2500; u += 90) {
            const Vec3 direction(sign * far, 0.03, low);
            const Pixel pixel{
                frame.at(u, frame.axis(2) + 37) - direction * 7000,
                direction,
                {Vec3(0), Vec3(0), Vec3(0, size, 0), Vec3(-sign * low, 0, far) * size}};
            EXPECT_NEAR(pixel.seen(frame), pixel.truth(frame, 200), 0.01) << sign << ", " << u;
        }
}

// The farthest places of an end are where the rim is a radius above or below the plane.
TEST(LampEnds, StayInTheirRoom) {
    test::Random random(18);
    for (int trial = 0; trial < 1000; ++trial) {
        const CPlaneFrame frame = row_of(30, 100, trial % 2 == 0);
        const Vec3 d = test::random_direction(random);
        const LampEnds ends = LampEnds::of_tubes(frame, d);
        for (const LampEnd& end : {ends.begin, ends.end}) {
            double most = 0;
            for (double angle = -1.5708; angle <= 1.5708; angle += 0.01)
                most = std::max(
                    most, std::abs(end.shear * std::sin(angle) + end.bulge * std::cos(angle)));
            EXPECT_NEAR(most, end_room(frame, d), 1e-3 * end_room(frame, d));
        }
    }
}

// Lamps from which a slanted look shows more of the rims than of the tubes between.
TEST(LampEnds, OfStubsAreSeenBothInOnePixel) {
    for (const bool luminous_caps : {false, true})
        for (const double slope : {-2.0, 2.0}) {
            CPlane plane;
            plane.origin = {0, 0, 2000};
            plane.u = {20, 0, 0};
            plane.v = {0, 200, 0};
            plane.lamps = 1, plane.diameter = 60;
            plane.luminous_caps = luminous_caps;
            const CPlaneFrame frame(plane);
            const Vec3 direction(slope, 0.7, 1);
            const Pixel pixel{frame.at(10, 100) - direction * 2000,
                              direction,
                              {Vec3(150, 40, 0), Vec3(-30, 120, 0), Vec3(0), Vec3(0)}};
            EXPECT_NEAR(pixel.seen(frame), pixel.truth(frame), 0.005);
            EXPECT_GT(pixel.truth(frame), 0.05);
        }
}
