#include "keiko/trace/occluders.h"

#include "tests/support/occluder_row.h"
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace keiko {
namespace {

using namespace test;

SeenParts seen(const SurfaceModel& model, const Vec3& apex, const Vec3& a, const Vec3& b) {
    const Tracer tracer(model);
    const Occluders occluders(model, tracer);
    const Vec3 region[2] = {a, b};
    return ApexView(occluders, tracer, Apex::at(apex), region).intervals(a, b);
}

TEST(Occluders, MeetTheOracleOfVisibleIntervals) {
    constexpr double tolerance = 1e-12;
    for (const OracleRow& row : OracleTable("visible_intervals")) {
        const SeenParts parts =
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

    IntervalSet seen(const Apex& apex, const Vec3& a, const Vec3& b) const {
        const Vec3 region[2] = {a, b};
        const SeenParts parts = ApexView(occluders, tracer, apex, region).intervals(a, b);
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
    expect_parts(Ball().seen(Apex::towards({0, 0, 2}), {-2, 0, -5}, {2, 0, -5}),
                 {{0, 0.25}, {0.75, 1}});
    expect_parts(Ball().seen(Apex::towards({0, 0, 2}), {-2, 0, 5}, {2, 0, 5}), {{0, 1}});
}

TEST(Occluders, EndAVisiblePartWhereTheSegmentEntersThem) {
    const double top = std::sqrt(0.75);
    expect_parts(Ball().seen(Apex::at({0, 0, 10}), {0.5, 0, 3}, {0.5, 0, -3}),
                 {{0, (3 - top) / 6}});
}

TEST(Occluders, HideASegmentSeenEndOnFromTheFirstSurfaceOn) {
    expect_parts(Ball().seen(Apex::at({0, 0, 10}), {0, 0, 5}, {0, 0, -5}), {{0, 0.4}});
}

TEST(Occluders, HideWhatLiesBelowTheHorizonOfTheirOwnPoint) {
    const Ball ball;
    Ray down;
    down.origin = {0.3, 0.4, 5};
    down.direction = {0, 0, -1};
    const auto hit = ball.tracer.nearest(down);
    ASSERT_TRUE(hit);
    const Vec3 n = hit->position, across = n.cross(Vec3(1, 0, 0)).normalized() * 3;
    expect_parts(ball.seen(Apex::at(hit->position, hit->root), n * 3 + across, n * -1 + across),
                 {{0, 0.5}});
}

TEST(Occluders, SeeAPointAsAWholeOrNotAtAll) {
    expect_parts(Ball().seen(Apex::at({0, 0, 10}), {0, 0, -5}, {0, 0, -5}), {});
    expect_parts(Ball().seen(Apex::at({0, 0, 10}), {3, 0, -5}, {3, 0, -5}), {{0, 1}});
}

/// Told of the eye, a view finds the same parts to the last bit: of rays to all sides, of rays out
/// of the light's way, and of segments that are on no ray from it.
TEST(Occluders, SeeTheSameOfRaysWhoseEyeIsKnown) {
    const Ball ball;
    const Vec3 lamp(0.5, 0.2, 6), eye(-7, -3, 0.4);
    std::vector<SegmentEnds> rays;
    std::vector<Vec3> region;
    for (int i = 0; i < 400; ++i) {
        const double turn = 0.3 * i, high = -3 + 0.015 * i;
        const Vec3 end(6 * std::cos(turn), 6 * std::sin(turn), high);
        rays.push_back({eye + (end - eye) * (i % 2 == 0 ? 0.0 : 0.4), end});
        if (i % 7 == 0) rays.back()[0] = Vec3(1, -4, -2);
        region.insert(region.end(), rays.back().begin(), rays.back().end());
    }
    const ApexView plain(ball.occluders, ball.tracer, Apex::at(lamp), region);
    const ApexView told(ball.occluders, ball.tracer, Apex::at(lamp), region, {}, eye);
    int cut = 0;
    for (const SegmentEnds& ray : rays) {
        const SeenParts expected = plain.intervals(ray[0], ray[1]);
        const SeenParts found = told.intervals(ray[0], ray[1]);
        EXPECT_EQ(found.certain, expected.certain);
        ASSERT_EQ(found.intervals.size(), expected.intervals.size());
        for (std::size_t i = 0; i < expected.intervals.size(); ++i) {
            EXPECT_EQ(found.intervals[i].begin, expected.intervals[i].begin);
            EXPECT_EQ(found.intervals[i].end, expected.intervals[i].end);
        }
        cut += expected.intervals.size() > 1 ? 1 : 0;
    }
    EXPECT_GT(cut, 30);
}

} // namespace
} // namespace keiko
