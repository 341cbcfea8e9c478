#include "keiko/visibility/query/visibility_query.h"

#include "tests/support/occluder_row.h"
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace keiko {
namespace {

using namespace test;

VisibleIntervals seen(const SurfaceModel& model, const Vec3& viewpoint, const Vec3& a,
                      const Vec3& b) {
    const Tracer tracer(model);
    const Occluders occluders(model, tracer);
    const Vec3 region[2] = {a, b};
    return VisibilityQuery(occluders, tracer, Viewpoint::at(viewpoint), region).intervals({a, b});
}

TEST(Occluders, MeetTheOracleOfVisibleIntervals) {
    constexpr double tolerance = 1e-12;
    for (const OracleRow& row : OracleTable("visible_intervals")) {
        const VisibleIntervals parts =
            seen(occluders_of(row), row.vector("in.P"), row.vector("in.A"), row.vector("in.B"));
        EXPECT_TRUE(parts.certain) << row.id();
        EXPECT_EQ(static_cast<int>(parts.intervals.size()), row.integer("out.n")) << row.id();
        std::vector<double> ends;
        for (const ParameterInterval& i : parts.intervals)
            ends.insert(ends.end(), {i.begin, i.end});
        const std::vector<double> expected = row.list("out.t");
        ASSERT_EQ(ends.size(), expected.size()) << row.id() << " " << testing::PrintToString(ends);
        for (std::size_t i = 0; i < ends.size(); ++i)
            EXPECT_NEAR(ends[i], expected[i], tolerance) << row.id();
    }
}

/// The unit sphere about the origin.
struct Ball {
    SurfaceModel model = sphere_model(Affine());
    Tracer tracer{model};
    Occluders occluders{model, tracer};

    IntervalSet seen(const Viewpoint& viewpoint, const Vec3& a, const Vec3& b) const {
        const Vec3 region[2] = {a, b};
        const VisibleIntervals parts =
            VisibilityQuery(occluders, tracer, viewpoint, region).intervals({a, b});
        EXPECT_TRUE(parts.certain);
        return parts.intervals;
    }
};

void expect_parts(const IntervalSet& seen, const std::vector<ParameterInterval>& expected) {
    ASSERT_EQ(seen.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_NEAR(seen[i].begin, expected[i].begin, 1e-12);
        EXPECT_NEAR(seen[i].end, expected[i].end, 1e-12);
    }
}

TEST(Occluders, CastTheShadowOfParallelLight) {
    expect_parts(Ball().seen(Viewpoint::towards({0, 0, 2}), {-2, 0, -5}, {2, 0, -5}),
                 {{0, 0.25}, {0.75, 1}});
    expect_parts(Ball().seen(Viewpoint::towards({0, 0, 2}), {-2, 0, 5}, {2, 0, 5}), {{0, 1}});
}

TEST(Occluders, EndAVisiblePartWhereTheSegmentEntersThem) {
    const double top = std::sqrt(0.75);
    expect_parts(Ball().seen(Viewpoint::at({0, 0, 10}), {0.5, 0, 3}, {0.5, 0, -3}),
                 {{0, (3 - top) / 6}});
}

TEST(Occluders, HideASegmentSeenEndOnFromTheFirstSurfaceOn) {
    expect_parts(Ball().seen(Viewpoint::at({0, 0, 10}), {0, 0, 5}, {0, 0, -5}), {{0, 0.4}});
}

TEST(Occluders, HideWhatLiesBelowTheHorizonOfTheirOwnPoint) {
    const Ball ball;
    Ray down;
    down.origin = {0.3, 0.4, 5};
    down.direction = {0, 0, -1};
    const auto hit = ball.tracer.nearest(down);
    ASSERT_TRUE(hit);
    const Vec3 n = hit->position, across = n.cross(Vec3(1, 0, 0)).normalized() * 3;
    expect_parts(
        ball.seen(Viewpoint::at(hit->position, hit->root), n * 3 + across, n * -1 + across),
        {{0, 0.5}});
}

TEST(Occluders, SeeAPointAsAWholeOrNotAtAll) {
    expect_parts(Ball().seen(Viewpoint::at({0, 0, 10}), {0, 0, -5}, {0, 0, -5}), {});
    expect_parts(Ball().seen(Viewpoint::at({0, 0, 10}), {3, 0, -5}, {3, 0, -5}), {{0, 1}});
}

} // namespace
} // namespace keiko
