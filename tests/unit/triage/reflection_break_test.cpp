#include "keiko/triage/reflection_break.h"

#include "keiko/base/units.h"
#include "keiko/math/vec.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// A mirror in the plane, an arc through the origin whose normal there is turned from +y by `turn`
/// radians; the eye sees the origin.
struct Mirror {
    double curvature; ///< 1/mm; convex to the eye
    double turn;
    Vec2 eye;

    double angle_at(double s) const { return turn - curvature * s; }
    /// The point `s` mm along the arc.
    Vec2 place(double s) const {
        // The integral of the tangent (cos, sin)(turn - curvature s), without cancellation.
        const double half = curvature * s / 2, mean = turn - half;
        const double chord = half != 0 ? s * std::sin(half) / half : s;
        return Vec2(std::cos(mean), std::sin(mean)) * chord;
    }
    /// Direction of the reflected ray of the eye at s, radians from +x.
    double reflected(double s) const {
        const Vec2 way = place(s) - eye;
        const double normal = angle_at(s) + std::acos(-1) / 2;
        return 2 * normal - std::atan2(way.y, way.x) + std::acos(-1);
    }
    /// Radians between the directions in which the eye sees s and the origin.
    double seen(double s) const {
        const Vec2 a = place(s) - eye, b = -eye;
        return std::abs(std::atan2(a.cross(b), a.dot(b)));
    }
    /// The place that reflects the eye's ray into a direction.
    double place_reflecting(double direction) const {
        const auto off = [&](double s) {
            return std::remainder(reflected(s) - direction, 2 * std::acos(-1));
        };
        double a = -1, b = 1;
        for (int i = 0; i < 60 && std::abs(off(b)) > 1e-14; ++i) {
            const double next = b - off(b) * (b - a) / (off(b) - off(a));
            a = b, b = next;
        }
        return b;
    }
};

Vec2 eye_at(double distance, double incidence) {
    return {distance * std::sin(incidence), distance * std::cos(incidence)};
}

double arc_minutes(double radians) {
    return 60 * radians_to_degrees(radians);
}

TEST(ReflectionBreak, OfAnAngleIsThatOfTracedRays) {
    constexpr double angle = 0.01; // degrees
    for (const double radius : {HUGE_VAL, 20000.0, 500.0, 30.0, -400.0, -50.0})
        for (const double incidence : {0.0, 0.5, 1.2})
            for (const double distance : {800.0, 4000.0}) {
                const Vec2 eye = eye_at(distance, incidence);
                const Mirror before{1 / radius, 0, eye};
                const Mirror after{1 / radius, degrees_to_radians(angle), eye};
                const double traced =
                    arc_minutes(after.seen(after.place_reflecting(before.reflected(0))));
                const double ours =
                    break_of_angle(angle, 1 / radius, {distance, std::cos(incidence)});
                EXPECT_NEAR(ours, traced, 2e-3 * traced)
                    << radius << ' ' << incidence << ' ' << distance;
            }
}

/// Arc minutes in which the eye sees a lamp of `lamp_width`, scaled from a narrow one.
double traced_width(double radius, const Vec2& eye) {
    constexpr double narrow = 1e-4; // radians
    const Mirror mirror{1 / radius, 0, eye};
    const double middle = mirror.reflected(0);
    return lamp_width / narrow *
           (mirror.seen(mirror.place_reflecting(middle + narrow / 2)) +
            mirror.seen(mirror.place_reflecting(middle - narrow / 2)));
}

/// -1 for a hollow mirror from far behind its focus.
double upright(double radius) {
    return radius < 0 && radius > -1000 ? -1 : 1;
}

TEST(ReflectionBreak, OfCurvaturesIsThatOfTracedRays) {
    for (const double a : {HUGE_VAL, 2000.0, 100.0, -700.0, -300.0})
        for (const double b : {5000.0, 300.0, -100.0})
            for (const double incidence : {0.0, 0.7}) {
                const Vec2 eye = eye_at(2000, incidence);
                // Behind the focus, at half the radius in the middle, the reflection turns over.
                const double of_a = traced_width(a, eye), of_b = traced_width(b, eye);
                const double fineness = std::min(1.0, std::min(of_a, of_b) / stripe_width);
                const double traced =
                    std::abs(of_a * upright(a) - of_b * upright(b)) * fineness * fineness;
                EXPECT_NEAR(break_of_curvatures(1 / a, 1 / b, {2000, std::cos(incidence)}), traced,
                            1e-3 * lamp_width)
                    << a << ' ' << b << ' ' << incidence;
            }
}

TEST(ReflectionBreak, OfAPlaneIsTwiceTheAngle) {
    EXPECT_DOUBLE_EQ(break_of_angle(0.5, 0, {3000, 0.3}), 60);
    EXPECT_EQ(break_of_angle(0.5, 0, {3000, 0}), 0) << "grazing";
    EXPECT_EQ(break_of_curvatures(0.01, 0.01, {3000, 1}), 0);
}

TEST(ReflectionBreak, IsBoundedNearTheFocusOfAHollowPlace) {
    for (const double radius : {-6000.0, -6000.1, -5999.9, -5800.0, -6300.0})
        EXPECT_EQ(std::abs(image_size(1 / radius, {3000, 1})), largest_image) << radius;
    EXPECT_GT(image_size(-1 / 6100.0, {3000, 1}), 0);
    EXPECT_LT(image_size(-1 / 5900.0, {3000, 1}), 0);
    EXPECT_LT(std::abs(image_size(-1 / 2000.0, {3000, 1})), largest_image);
}

TEST(ReflectionBreak, OfAnInflectionIsTheSumOfBothWidths) {
    const LineOfSight sight{3000, 1};
    const double bulged = image_size(1 / 2000.0, sight), hollow = image_size(-1 / 2000.0, sight);
    EXPECT_NEAR(bulged, 0.25, 1e-15);
    EXPECT_NEAR(hollow, -0.5, 1e-15);
    EXPECT_NEAR(break_of_curvatures(1 / 2000.0, -1 / 2000.0, sight), 0.75 * lamp_width, 1e-12);
}

TEST(ReflectionBreak, PoolsLengthsByTheirBreaksToAPower) {
    EXPECT_NEAR(break_of_pooled(pooled(7, pooling_length)), 7, 1e-12);
    EXPECT_NEAR(break_of_pooled(8 * pooled(7, 30) + 8 * pooled(7, 30)), 14, 1e-12) << "8 = 2 cubed";
    EXPECT_EQ(break_of_pooled(0), 0);
}

TEST(ReflectionBreak, OfAGapIsItsOwnWidth) {
    const double small_angle = arc_minutes(0.5 / 2000); // to its third power
    EXPECT_NEAR(break_of_gap(0.5, {2000, 1}), small_angle, 1e-7 * small_angle);
}

TEST(ReflectionBreak, BesideAFilletThereIsNoStripeThatChanges) {
    const LineOfSight sight{3000, 1};
    const double fillet = break_of_curvatures(0, 1 / 15.0, sight);
    EXPECT_LT(fillet, 0.005 * lamp_width);
    EXPECT_LT(fillet, break_of_angle(0.01, 0, sight));
    EXPECT_GT(break_of_curvatures(0, 1 / 2000.0, sight), 0.7 * lamp_width);
}

TEST(ReflectionBreak, OfAGapIsAtMostALamp) {
    EXPECT_NEAR(break_of_gap_angle(0.155), 9.3, 1e-12);
    EXPECT_EQ(break_of_gap_angle(3), lamp_width);
}

TEST(ReflectionBreak, LampWidthIsThatOfATube) {
    EXPECT_NEAR(lamp_width, arc_minutes(60.0 / 2000), 0.1);
}

} // namespace
} // namespace keiko
