#include "keiko/intersect/roots/root_finder.h"

#include "tests/support/random_patches.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

using namespace test;

constexpr double slack = 1e-15;

/// Coefficients of the quadratic (x - a)(x - b) in Bernstein form.
std::array<double, 3> quadratic(double a, double b) {
    return {a * b, a * b - (a + b) / 2, (1 - a) * (1 - b)};
}

/// f + h (a quadratic in u) and g (a quadratic in v), turned by `angle` into each other.
PlanarNet crossed(const std::array<double, 3>& in_u, const std::array<double, 3>& in_v,
                  double angle) {
    PlanarNet net;
    net.degree_u = net.degree_v = 2;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            net.f[3 * i + j] = std::cos(angle) * in_u[i] - std::sin(angle) * in_v[j];
            net.g[3 * i + j] = std::sin(angle) * in_u[i] + std::cos(angle) * in_v[j];
        }
    return net;
}

class RootFinderModes : public testing::TestWithParam<bool> {
protected:
    RootFinder finder{GetParam()};
};

INSTANTIATE_TEST_SUITE_P(, RootFinderModes, testing::Values(false, true), [](const auto& kind) {
    return std::string(kind.param ? "Clipping" : "Proving");
});

TEST_P(RootFinderModes, FindFourRootsOfCrossedParabolas) {
    for (const double angle : {0.0, 0.3, 1.0, 2.5}) {
        const auto roots =
            finder.find(crossed(quadratic(0.2, 0.7), quadratic(0.1, 0.9), angle), slack);
        ASSERT_EQ(roots.size(), 4u) << angle;
        for (const double u : {0.2, 0.7})
            for (const double v : {0.1, 0.9})
                EXPECT_TRUE(std::any_of(roots.begin(), roots.end(), [&](const SubPatchRoot& r) {
                    return (r.uv - Vec2(u, v)).length() < 1e-13 && !r.tangential;
                }));
    }
}

TEST_P(RootFinderModes, SeparateTwoRootsThatNearlyTouch) {
    for (const double apart : {1e-2, 1e-4, 1e-6}) {
        const auto roots =
            finder.find(crossed(quadratic(0.4, 0.4 + apart), quadratic(0.5, 3), 0.7), slack);
        ASSERT_EQ(roots.size(), 2u) << apart;
        EXPECT_NEAR(std::abs(roots[0].uv.x - roots[1].uv.x), apart, 1e-8);
    }
}

TEST_P(RootFinderModes, FlagATangency) {
    for (const double angle : {0.0, 0.4, 0.785, 2.0}) {
        const auto roots =
            finder.find(crossed(quadratic(0.4, 0.4), quadratic(0.3, 3), angle), slack);
        ASSERT_EQ(roots.size(), 1u) << angle;
        EXPECT_TRUE(roots[0].tangential);
        EXPECT_NEAR(roots[0].uv.x, 0.4, 1e-6);
        EXPECT_NEAR(roots[0].uv.y, 0.3, 1e-6);
    }
}

TEST_P(RootFinderModes, ProveAbsenceCloseToATangency) {
    std::array<double, 3> lifted = quadratic(0.4, 0.4);
    for (double& c : lifted) c += 1e-10;
    EXPECT_TRUE(finder.find(crossed(lifted, quadratic(0.3, 3), 0.4), slack).empty());
}

TEST_P(RootFinderModes, FindTheRootOfRandomNets) {
    Random random(3);
    for (int i = 0; i < 20000; ++i) {
        PlanarNet net;
        net.degree_u = 1 + i % 5;
        net.degree_v = 1 + i / 5 % 5;
        for (std::size_t k = 0; k < net.size(); ++k) {
            net.f[k] = uniform(random, -1, 1);
            net.g[k] = uniform(random, -1, 1);
        }
        const Vec2 root(uniform(random, 0, 1), uniform(random, 0, 1));
        const PlanarPoint at = evaluate(net, root);
        for (std::size_t k = 0; k < net.size(); ++k) {
            net.f[k] -= at.value.x;
            net.g[k] -= at.value.y;
        }
        const auto roots = finder.find(net, 4 * slack);
        const bool found = std::any_of(roots.begin(), roots.end(), [&](const SubPatchRoot& r) {
            const Vec2 off = r.uv - root;
            return std::abs(off.x) <= 2 * r.error.x + 1e-12 &&
                   std::abs(off.y) <= 2 * r.error.y + 1e-12;
        });
        ASSERT_TRUE(found) << i << " among " << roots.size();
    }
}

TEST(RootFinder, CallsEndsOfALineInTheSurfaceTangential) {
    PlanarNet net; // f is zero everywhere, g = u + v - 0.5
    net.degree_u = net.degree_v = 1;
    net.f = {0, 0, 0, 0};
    net.g = {-0.5, 0.5, 0.5, 1.5};
    RootFinder finder;
    const auto roots = finder.find(net, slack);
    ASSERT_EQ(roots.size(), 2u);
    for (const SubPatchRoot& r : roots) {
        EXPECT_TRUE(r.tangential);
        EXPECT_NEAR(r.uv.x + r.uv.y, 0.5, 1e-12);
    }
}

} // namespace
} // namespace keiko
