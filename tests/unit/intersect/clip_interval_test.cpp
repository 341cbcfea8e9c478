#include "keiko/intersect/roots/planar_net.h"

#include <gtest/gtest.h>

namespace keiko {
namespace {

TEST(HullClip, CutsALinearFunctionDownToItsZero) {
    const double net[] = {-1, -1, 3, 3}; // 4 u - 1
    const ParameterInterval u = clip_interval(net, 2, 2, Axis::u, 0);
    EXPECT_NEAR(u.begin, 0.25, 1e-14);
    EXPECT_NEAR(u.end, 0.25, 1e-14);
    const ParameterInterval v = clip_interval(net, 2, 2, Axis::v, 0);
    EXPECT_EQ(v.begin, 0);
    EXPECT_EQ(v.end, 1);
}

TEST(HullClip, IsEmptyWhereTheFunctionKeepsItsSign) {
    const double positive[] = {1, 2, 3, 4, 5, 6}, negative[] = {-1, -2, -3, -4, -5, -6};
    for (const Axis axis : {Axis::u, Axis::v}) {
        const ParameterInterval a = clip_interval(positive, 2, 3, axis, 0.5);
        const ParameterInterval b = clip_interval(negative, 2, 3, axis, 0.5);
        EXPECT_GT(a.begin, a.end);
        EXPECT_GT(b.begin, b.end);
    }
}

TEST(HullClip, SlackWidensTheInterval) {
    const double net[] = {-1, -1, 1, 1};
    const ParameterInterval u = clip_interval(net, 2, 2, Axis::u, 0.1);
    EXPECT_NEAR(u.begin, 0.45, 1e-14);
    EXPECT_NEAR(u.end, 0.55, 1e-14);
}

} // namespace
} // namespace keiko
