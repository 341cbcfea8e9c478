#include "keiko/geometry/bezier/parameter_map.h"

#include "keiko/geometry/bezier/bezier.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace keiko;

namespace {

const std::vector<ParameterMap> maps{{ParameterMap::Kind::affine, -2, 5},
                                     {ParameterMap::Kind::circular, 0.25, 1.75},
                                     {ParameterMap::Kind::hyperbolic, -0.5, 2}};

} // namespace

TEST(ParameterMap, RunsFromBeginToEndAndBack) {
    for (const ParameterMap& map : maps) {
        EXPECT_NEAR(map.to_face(0), map.begin, 1e-15);
        EXPECT_NEAR(map.to_face(1), map.end, 1e-15);
        for (double t = -0.1; t <= 1.1; t += 0.1)
            EXPECT_NEAR(map.to_patch(map.to_face(t)), t, 1e-14);
    }
}

TEST(ParameterMap, DerivativesMatchDifferences) {
    const double h = 1e-6;
    for (const ParameterMap& map : maps)
        for (double t = 0; t <= 1; t += 0.125) {
            EXPECT_NEAR(map.derivative(t), (map.to_face(t + h) - map.to_face(t - h)) / (2 * h),
                        1e-8);
            EXPECT_NEAR(map.second_derivative(t),
                        (map.derivative(t + h) - map.derivative(t - h)) / (2 * h), 1e-7);
        }
}

TEST(ParameterMap, RangesHoldTheDerivativesAndLittleMore) {
    for (const ParameterMap& map : maps)
        for (double begin = 0; begin < 1; begin += 0.0625) {
            const double width = 1.0 / 64;
            const ParameterRanges ranges = parameter_ranges(map, {begin, begin + width});
            for (int k = 0; k <= 8; ++k) {
                const double t = begin + width * k / 8;
                EXPECT_LE(ranges.first.low, map.derivative(t));
                EXPECT_GE(ranges.first.high, map.derivative(t));
                EXPECT_LE(ranges.second.low, map.second_derivative(t));
                EXPECT_GE(ranges.second.high, map.second_derivative(t));
            }
            EXPECT_LT(ranges.first.high - ranges.first.low, 8 * width);
            EXPECT_LT(ranges.second.high - ranges.second.low, 32 * width);
        }
}

TEST(ParameterMap, IsTheAngleOfAStandardRationalArc) {
    const double begin = 0.25, end = 1.75, half = (end - begin) / 2, middle = (begin + end) / 2;
    const double w = std::cos(half);
    const std::vector<Vec3> arc{{std::cos(begin), std::sin(begin), 1},
                                {std::cos(middle), std::sin(middle), w},
                                {std::cos(end), std::sin(end), 1}};
    const ParameterMap map{ParameterMap::Kind::circular, begin, end};
    for (double t = 0; t <= 1; t += 0.1) {
        const Vec2 p = evaluate(BezierCurveView{arc}, t, 0)[0];
        EXPECT_NEAR(std::atan2(p.y, p.x), map.to_face(t), 1e-15);
    }
}

TEST(ParameterMap, IsTheParameterOfAStandardRationalHyperbola) {
    const double begin = -0.5, end = 2, half = (end - begin) / 2, middle = (begin + end) / 2;
    const double w = std::cosh(half);
    const std::vector<Vec3> arc{{std::cosh(begin), std::sinh(begin), 1},
                                {std::cosh(middle), std::sinh(middle), w},
                                {std::cosh(end), std::sinh(end), 1}};
    const ParameterMap map{ParameterMap::Kind::hyperbolic, begin, end};
    for (double t = 0; t <= 1; t += 0.1) {
        const Vec2 p = evaluate(BezierCurveView{arc}, t, 0)[0];
        EXPECT_NEAR(std::asinh(p.y), map.to_face(t), 1e-14);
        EXPECT_NEAR(p.x, std::cosh(map.to_face(t)), 1e-13);
    }
}
