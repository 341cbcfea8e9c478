#include "keiko/visibility/boundaries/plane_cuts.h"

#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace keiko;
using namespace keiko::test;

namespace {

/// A curve that may wind several times about the plane through the viewpoint and the segment.
BoundaryPiece winding_border(Random& random) {
    BoundaryPiece piece;
    piece.center = Vec3(0, 0, uniform(random, 40, 60));
    piece.radius = 1e3;
    piece.inward_error = std::numbers::pi / 2;
    for (std::size_t i = 0; i < piece.curve.size(); ++i)
        piece.curve[i] = Vec3(10.0 * static_cast<double>(i) - 25, uniform(random, -6, 6),
                              uniform(random, -3, 3));
    return piece;
}

/// Place between a and b, where f has different signs, at which it changes its sign.
template <class F>
double zero_between(const F& f, double a, double b) {
    const bool below = f(a) < 0;
    while (b - a > 1e-15) {
        const double middle = (a + b) / 2;
        ((f(middle) < 0) == below ? a : b) = middle;
    }
    return (a + b) / 2;
}

/// Whether f, above 0, falls from either end of a small step.
template <class F>
bool sinks_within(const F& f, double a, double b) {
    const double little = (b - a) * 1e-6;
    return f(a + little) < f(a) && f(b - little) < f(b);
}

/// Place between a and b at which f is least, if it has one minimum there.
template <class F>
double least_between(const F& f, double a, double b) {
    while (b - a > 1e-9) {
        const double third = (b - a) / 3;
        if (f(a + third) < f(b - third))
            b -= third;
        else
            a += third;
    }
    return (a + b) / 2;
}

/// Parameters of the curve at which the distance to the plane changes its sign, found by small
/// steps. Where it is least within a step of one sign, a pair of zeros may lie between.
std::vector<double> crossings(const BoundaryPiece& piece, const SegmentPlane& plane) {
    const Vec4 w = plane.weights(piece.center);
    const auto distance = [&](double t) {
        const Vec3 p = piece.at(t);
        return w.dot(Vec4(p.x, p.y, p.z, 1));
    };
    const auto differ = [&](double a, double b) { return (distance(a) < 0) != (distance(b) < 0); };
    std::vector<double> found;
    constexpr int steps = 1000;
    for (int i = 0; i < steps; ++i) {
        const double a = double(i) / steps, b = double(i + 1) / steps;
        if (differ(a, b)) {
            found.push_back(zero_between(distance, a, b));
            continue;
        }
        const double side = distance(a) < 0 ? -1 : 1;
        const auto away = [&](double t) { return side * distance(t); };
        if (!sinks_within(away, a, b)) continue;
        const double least = least_between(away, a, b);
        if (!differ(a, least)) continue;
        found.push_back(zero_between(distance, a, least));
        found.push_back(zero_between(distance, least, b));
    }
    return found;
}

} // namespace

TEST(BorderEvents, AreAllCrossingsOfThePlaneOfASegment) {
    Random random(91);
    std::array<int, 6> by_count{};
    const Viewpoint viewpoint = Viewpoint::at(Vec3(0, 0, 0));
    const auto plane = SegmentPlane::through(viewpoint, Vec3(-90, 0, 100), Vec3(90, 0, 100));
    ASSERT_TRUE(plane);
    for (int trial = 0; trial < 3000; ++trial) {
        const BoundaryPiece piece = winding_border(random);
        std::vector<VisibilityEvent> events;
        find_border_events(piece, {}, *plane, events);
        std::vector<double> wanted, got;
        for (const double t : crossings(piece, *plane)) {
            const Vec3 x = piece.center + piece.at(t);
            wanted.push_back((x.x / x.z * 100 + 90) / 180);
        }
        for (const VisibilityEvent& event : events) got.push_back(event.t);
        std::sort(wanted.begin(), wanted.end());
        std::sort(got.begin(), got.end());
        ++by_count[std::min<std::size_t>(wanted.size(), 5)];
        ASSERT_EQ(got.size(), wanted.size());
        for (std::size_t i = 0; i < got.size(); ++i) EXPECT_NEAR(got[i], wanted[i], 1e-9);
    }
    for (const std::size_t several : {1, 2, 3}) EXPECT_GT(by_count[several], 100);
}

TEST(BorderEvents, LieOnThePlaneToRounding) {
    Random random(92);
    const Viewpoint viewpoint = Viewpoint::at(Vec3(0, 0, 0));
    for (int trial = 0; trial < 500; ++trial) {
        const BoundaryPiece piece = winding_border(random);
        const Vec3 a(-90, uniform(random, -5, 5), 100), b(90, uniform(random, -5, 5), 100);
        const auto plane = SegmentPlane::through(viewpoint, a, b);
        std::vector<VisibilityEvent> events;
        find_border_events(piece, {}, *plane, events);
        EXPECT_EQ(events.size(), crossings(piece, *plane).size());
        for (const VisibilityEvent& event : events) {
            // The line from the viewpoint through the event passes the curve.
            const Vec3 way = plane->at(event.t).normalized();
            double nearest = 1e300, at = 0;
            const auto off = [&](double t) {
                return (piece.center + piece.at(t)).cross(way).length();
            };
            for (int i = 0; i <= 1000; ++i)
                if (off(i / 1000.0) < nearest) nearest = off(at = i / 1000.0);
            for (double step = 1e-3; step > 1e-16; step /= 2)
                for (const double next : {at - step, at + step})
                    if (off(next) < nearest) nearest = off(at = next);
            EXPECT_LT(nearest, 1e-11);
        }
    }
}

namespace {

/// From (-20, y0, 50) to (20, y2, 50): a parabola of these heights.
BoundaryPiece parabola(double y0, double y1, double y2) {
    BoundaryPiece piece;
    piece.center = Vec3(0, 0, 50);
    piece.radius = 1e3;
    piece.error = 1e-8;
    const auto at = [&](double t) { // the polar form
        return [=](double s) {
            return y0 * (1 - t) * (1 - s) + y1 * (t + s - 2 * t * s) + y2 * t * s;
        };
    };
    // Control points of degree 5: means of the polar form over pairs of five zeros and ones.
    for (std::size_t i = 0; i <= 5; ++i) {
        const double n = static_cast<double>(i), m = 5 - n;
        const double y =
            (n * (n - 1) * at(1)(1) + 2 * n * m * at(0)(1) + m * (m - 1) * at(0)(0)) / 20;
        piece.curve[i] = Vec3(8 * n - 20, y, 0);
    }
    return piece;
}

std::vector<VisibilityEvent> events_of(const BoundaryPiece& piece) {
    const Viewpoint viewpoint = Viewpoint::at(Vec3(0, 0, 0));
    const auto plane = SegmentPlane::through(viewpoint, Vec3(-90, 0, 100), Vec3(90, 0, 100));
    std::vector<VisibilityEvent> events;
    find_border_events(piece, {}, *plane, events);
    std::sort(events.begin(), events.end(), [](const auto& a, const auto& b) { return a.t < b.t; });
    return events;
}

} // namespace

TEST(BorderEvents, MarkTheEndsOfABorderThatLiesInThePlane) {
    for (const double off : {0.0, 7e-12, -5e-9, 9e-9}) {
        const auto events = events_of(parabola(off, off, off));
        ASSERT_EQ(events.size(), 2u) << off;
        EXPECT_NEAR(events[0].t, 50.0 / 180, 1e-9);
        EXPECT_NEAR(events[1].t, 130.0 / 180, 1e-9);
        for (const VisibilityEvent& event : events) EXPECT_EQ(event.dark, 0);
    }
    EXPECT_TRUE(events_of(parabola(2e-8, 2e-8, 2e-8)).empty());
}

TEST(BorderEvents, MarkWhereABorderTouchesThePlane) {
    // Lowest, by `least`, at t = 1/4.
    const auto touching = [](double least) { return parabola(1 + least, -3 + least, 9 + least); };
    for (const double least : {0.0, 7e-12, 9e-9}) {
        const auto events = events_of(touching(least));
        ASSERT_FALSE(events.empty()) << least;
        for (const VisibilityEvent& event : events) EXPECT_NEAR(event.t, 70.0 / 180, 1e-6) << least;
    }
    EXPECT_TRUE(events_of(touching(2e-8)).empty());
    EXPECT_EQ(events_of(touching(-1e-3)).size(), 2u);
}
