#include "keiko/visibility/nets/affine_bounds.h"

#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <algorithm>

using namespace keiko;
using namespace keiko::test;

namespace {

Vec4 random_point(Random& random) {
    return {uniform(random, -9, 9), uniform(random, -9, 9), uniform(random, -9, 9),
            uniform(random, 0.5, 2)};
}

HomogeneousNet random_net(Random& random) {
    HomogeneousNet net{static_cast<int>(pick(random, 6)), static_cast<int>(pick(random, 6)), {}};
    const auto count = static_cast<std::size_t>((net.degree_u + 1) * (net.degree_v + 1));
    for (std::size_t i = 0; i < count; ++i) net.points.push_back(random_point(random));
    return net;
}

/// The coefficients themselves, by de Casteljau.
Vec4 value_at(const HomogeneousNet& net, double u, double v) {
    const auto on_line = [](std::vector<Vec4> points, double t) {
        for (std::size_t last = points.size() - 1; last > 0; --last)
            for (std::size_t i = 0; i < last; ++i) points[i] += (points[i + 1] - points[i]) * t;
        return points[0];
    };
    std::vector<Vec4> column;
    for (int i = 0; i <= net.degree_u; ++i) {
        const auto row = net.points.begin() + i * (net.degree_v + 1);
        column.push_back(on_line({row, row + net.degree_v + 1}, v));
    }
    return on_line(column, u);
}

} // namespace

TEST(AffineBounds, HoldValuesAndSlopesOfEveryWeighing) {
    Random random(71);
    for (int trial = 0; trial < 300; ++trial) {
        const HomogeneousNet net = random_net(random);
        const Vec4 weights = random_point(random);
        const AffineBounds::Weighed f = affine_bounds(net).weighed(weights);
        const auto rest = [&](double x, double y) {
            return weights.dot(value_at(net, (x + 1) / 2, (y + 1) / 2)) - f.value - f.along_x * x -
                   f.along_y * y;
        };
        for (int i = 0; i < 50; ++i) {
            const double x = uniform(random, -1, 1), y = uniform(random, -1, 1);
            EXPECT_LE(std::abs(rest(x, y)), f.off);
            constexpr double step = 1e-6;
            const double by_x = (rest(x + step, y) - rest(x - step, y)) / (2 * step);
            const double by_y = (rest(x, y + step) - rest(x, y - step)) / (2 * step);
            EXPECT_LE(std::abs(by_x) + std::abs(by_y), f.slope + 1e-6);
        }
    }
}

TEST(AffineBounds, OfAnAffineNetAreItsValues) {
    Random random(72);
    for (int trial = 0; trial < 100; ++trial) {
        HomogeneousNet net = random_net(random);
        const Vec4 a = random_point(random), b = random_point(random), c = random_point(random);
        const Vec4 along_x = net.degree_u > 0 ? b : Vec4(0);
        const Vec4 along_y = net.degree_v > 0 ? c : Vec4(0);
        const auto place = [](int i, int degree) { return degree > 0 ? 2.0 * i / degree - 1 : 0; };
        std::size_t next = 0;
        for (int i = 0; i <= net.degree_u; ++i)
            for (int j = 0; j <= net.degree_v; ++j)
                net.points[next++] =
                    a + along_x * place(i, net.degree_u) + along_y * place(j, net.degree_v);
        const AffineBounds bounds = affine_bounds(net);
        EXPECT_LT((bounds.value - a).length(), 1e-13);
        EXPECT_LT(bounds.off.length(), 1e-12);
        EXPECT_LT(bounds.slope.length(), 1e-11);
        EXPECT_LT((bounds.along_x - along_x).length(), 1e-13);
        EXPECT_LT((bounds.along_y - along_y).length(), 1e-13);
    }
}
