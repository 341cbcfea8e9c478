#include "keiko/visibility/query/visibility_query.h"

#include "tests/support/shapes.h"
#include <gtest/gtest.h>

#include <array>

namespace keiko {
namespace {

using namespace test;

/// Two sheets 10 wide in x and 20 in y that share the edge x = 0, z = 0 except for a gap in x, and
/// fall by `slope` to either side.
SurfaceModel roof(double slope, double gap) {
    ShapeBuilder builder;
    const std::uint32_t edge = builder.edge(0);
    for (const double side : {-1.0, 1.0}) {
        const double inner = side > 0 ? gap : 0, outer = side * 10, low = -10 * slope;
        builder.face({bilinear(Vec3(inner, -10, 0), Vec3(outer, -10, low), Vec3(inner, 10, 0),
                               Vec3(outer, 10, low))},
                     {polygon({Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)}, edge)});
    }
    return builder.model();
}

void expect_seen(const SurfaceModel& model, const Vec3& viewpoint, const Segment& ends,
                 const std::vector<ParameterInterval>& expected) {
    const Tracer tracer(model);
    const Occluders occluders(model, tracer);
    const VisibilityQuery view(occluders, tracer, Viewpoint::at(viewpoint),
                               std::array{ends.a, ends.b});
    const VisibleIntervals seen = view.intervals(ends);
    EXPECT_TRUE(seen.certain);
    ASSERT_EQ(seen.intervals.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_NEAR(seen.intervals[i].begin, expected[i].begin, 1e-12);
        EXPECT_NEAR(seen.intervals[i].end, expected[i].end, 1e-12);
    }
}

const Segment below{Vec3(-40, 0, -50), Vec3(40, 0, -50)};

TEST(SharedBorders, EndNoPartWhereTheSurfaceGoesOn) {
    expect_seen(roof(0, 0), {1, 0, 50}, below, {{0, 0.2375}, {0.7375, 1}});
}

TEST(SharedBorders, EndNoPartAtARidgeSeenFromAbove) {
    expect_seen(roof(2, 0), {0.5, 0, 30}, below, {{0, 0.29625}, {0.69625, 1}});
}

TEST(SharedBorders, EndAPartAtARidgeSeenFromOneSide) {
    expect_seen(roof(2, 0), {-20, 0, -10}, {Vec3(20, 0, -40), Vec3(20, 0, 40)}, {{0.625, 1}});
}

TEST(SharedBorders, LetLightThroughAGapThatIsNoSeam) {
    expect_seen(roof(0, 1e-2), {1, 0, 50}, below, {{0, 0.2375}, {0.4875, 0.48775}, {0.7375, 1}});
}

} // namespace
} // namespace keiko
