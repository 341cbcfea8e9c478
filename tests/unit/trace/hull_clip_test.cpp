#include "keiko/trace/hull_clip.h"

#include "keiko/trace/planar_net.h"

#include "tests/unit/trace/random_patches.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

using namespace test;

TEST(HullClip, CutsALinearFunctionDownToItsZero) {
    const double net[] = {-1, -1, 3, 3}; // 4 u - 1
    const ParameterInterval u = hull_clip(net, 2, 2, Axis::u, 0);
    EXPECT_NEAR(u.begin, 0.25, 1e-14);
    EXPECT_NEAR(u.end, 0.25, 1e-14);
    const ParameterInterval v = hull_clip(net, 2, 2, Axis::v, 0);
    EXPECT_EQ(v.begin, 0);
    EXPECT_EQ(v.end, 1);
}

TEST(HullClip, IsEmptyWhereTheFunctionKeepsItsSign) {
    const double positive[] = {1, 2, 3, 4, 5, 6}, negative[] = {-1, -2, -3, -4, -5, -6};
    for (const Axis axis : {Axis::u, Axis::v}) {
        const ParameterInterval a = hull_clip(positive, 2, 3, axis, 0.5);
        const ParameterInterval b = hull_clip(negative, 2, 3, axis, 0.5);
        EXPECT_GT(a.begin, a.end);
        EXPECT_GT(b.begin, b.end);
    }
}

TEST(HullClip, SlackWidensTheInterval) {
    const double net[] = {-1, -1, 1, 1};
    const ParameterInterval u = hull_clip(net, 2, 2, Axis::u, 0.1);
    EXPECT_NEAR(u.begin, 0.45, 1e-14);
    EXPECT_NEAR(u.end, 0.55, 1e-14);
}

TEST(HullClip, NeverCutsAwayARoot) {
    Random random(1);
    for (int i = 0; i < 20000; ++i) {
        PlanarNet net;
        net.degree_u = 1 + i % 6;
        net.degree_v = 1 + i / 6 % 5;
        for (std::size_t k = 0; k < net.size(); ++k)
            net.f[k] = uniform(random, -1, 1), net.g[k] = 0;
        const Vec2 root(uniform(random, 0, 1), uniform(random, 0, 1));
        const double value = evaluate(net, root).value.x;
        for (std::size_t k = 0; k < net.size(); ++k) net.f[k] -= value;
        const std::span<const double> f(net.f.data(), net.size());
        const ParameterInterval u = hull_clip(f, net.rows(), net.columns(), Axis::u, 1e-15);
        const ParameterInterval v = hull_clip(f, net.rows(), net.columns(), Axis::v, 1e-15);
        ASSERT_TRUE(u.begin <= root.x && root.x <= u.end) << i;
        ASSERT_TRUE(v.begin <= root.y && root.y <= v.end) << i;
    }
}

} // namespace
} // namespace keiko
