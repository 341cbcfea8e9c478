#include "keiko/geometry/bezier/parameter_metric.h"

#include <gtest/gtest.h>

#include <random>

namespace keiko {
namespace {

using Random = std::mt19937_64;

double uniform(Random& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

Vec3 vector(Random& random) {
    return {uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)};
}

TEST(ParameterMetric, IsTheLengthOfTheStepInSpace) {
    Random random(1);
    for (int i = 0; i < 100; ++i) {
        const Vec3 du = vector(random), dv = vector(random);
        const Vec2 step(uniform(random, -3, 3), uniform(random, -3, 3));
        EXPECT_NEAR(ParameterMetric(du, dv).length(step), (du * step.x + dv * step.y).length(),
                    1e-12);
    }
}

TEST(ParameterMetric, DistanceToABoxIsThatOfItsNearestPlace) {
    Random random(2);
    for (int i = 0; i < 200; ++i) {
        const ParameterMetric metric(vector(random), vector(random));
        const Box2 box{Vec2(-1, -0.5), Vec2(uniform(random, -1, 2), uniform(random, -0.5, 2))};
        const Vec2 p(uniform(random, -3, 3), uniform(random, -3, 3));
        double least = std::numeric_limits<double>::infinity();
        constexpr int steps = 60;
        for (int u = 0; u <= steps; ++u)
            for (int v = 0; v <= steps; ++v) {
                const Vec2 at = box.lower + box.extent() * Vec2(u, v) / steps;
                least = std::min(least, metric.length(at - p));
            }
        const double found = metric.distance(p, box);
        EXPECT_LE(found, least * (1 + 1e-12));
        EXPECT_GE(found, least - metric.across(box.extent()) / steps);
    }
}

TEST(ParameterMetric, LeastIsTheShortestWayToGoOn) {
    const ParameterMetric slanted(Vec3(1, 0, 0), Vec3(1, 1, 0));
    EXPECT_NEAR(slanted.least().x, std::sqrt(0.5), 1e-15);
    EXPECT_NEAR(slanted.least().y, 1, 1e-15);
    const ParameterMetric pole{Vec2(0, 2)};
    EXPECT_EQ(pole.least(), Vec2(0, 2));
}

} // namespace
} // namespace keiko
