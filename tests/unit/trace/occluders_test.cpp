#include "keiko/trace/occluders.h"

#include "tests/support/occluder_row.h"
#include <gtest/gtest.h>

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
        std::vector<double> ends;
        for (const ParameterInterval& i : parts.intervals)
            ends.insert(ends.end(), {i.begin, i.end});
        const std::vector<double> expected = row.list("out.t");
        ASSERT_EQ(ends.size(), expected.size()) << row.id() << " " << testing::PrintToString(ends);
        for (std::size_t i = 0; i < ends.size(); ++i)
            EXPECT_NEAR(ends[i], expected[i], tolerance) << row.id();
    }
}

} // namespace
} // namespace keiko
