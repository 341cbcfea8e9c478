#include "keiko/inspect/flaws/face_ripples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

/// The curvature of a line 200 mm long, sampled every 2 mm.
template <class Bend>
std::vector<BendPoint> line(const Bend& bend) {
    std::vector<BendPoint> points;
    for (double s = 0; s <= 200; s += 2) points.push_back({s, {bend(s)}});
    return points;
}

/// Curvature of the line depth * sin(2 pi s / length).
double sine_bend(double s, double depth, double length) {
    const double k = 2 * std::numbers::pi / length;
    return -depth * k * k * std::sin(k * s);
}

TEST(Ripple, IsAsDeepAsTheSineThatBendsAsMuch) {
    for (const double form : {0.0, 0.002}) {
        const auto points = line([&](double s) { return form + sine_bend(s, 0.05, 40); });
        const std::vector<Ripple> ripples = find_ripples(points, 0.01, 100);
        ASSERT_GE(ripples.size(), 6u);
        for (const Ripple& r : ripples) {
            EXPECT_NEAR(std::abs(r.depth), 0.05, 0.005);
            EXPECT_NEAR(r.width, 40, 4);
            const double height = std::sin(2 * std::numbers::pi * points[r.index].length / 40);
            EXPECT_GT(height * r.depth, 0) << "positive on crests";
        }
    }
}

TEST(Ripple, IsNoneThatIsWiderThanTheWindowOrShallow) {
    const auto points = line([](double s) { return sine_bend(s, 0.05, 40); });
    EXPECT_TRUE(find_ripples(points, 0.01, 30).empty());
    // Up to 44 mm long, with turns seen to the next of the points.
    EXPECT_TRUE(find_ripples(points, 0.05 * 1.1 * 1.1 + 0.001, 100).empty());
}

/// A line of few points shows less of a short wave than there is.
TEST(Ripple, MayBeAsDeepAsItIsWhereFewPointsAreOnIt) {
    for (const double length : {10.0, 12.0, 15.0}) {
        const auto points = line([&](double s) { return sine_bend(s, 0.05, length); });
        const std::vector<Ripple> ripples = find_ripples(points, 0.04, 100);
        EXPECT_GE(static_cast<double>(ripples.size()), 2 * 200 / length - 3) << length;
        for (const Ripple& r : ripples) EXPECT_GE(r.deepest, 0.045) << length;
    }
}

TEST(Ripple, IsNoneWhereTheFormBendsOnceOrTurnsItsSense) {
    const auto fillet = [](double s) { return 0.05 * std::exp(-std::pow((s - 100) / 15, 2)); };
    EXPECT_TRUE(find_ripples(line(fillet), 1e-4, 100).empty());
    const auto step = [&](double s) { return fillet(s) * (s - 100) / 15; };
    EXPECT_TRUE(find_ripples(line(step), 1e-4, 40).empty());
    EXPECT_TRUE(find_ripples({}, 1e-4, 100).empty());
}

} // namespace
} // namespace keiko
