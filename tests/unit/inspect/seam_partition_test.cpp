#include "keiko/inspect/seams/seam_partition.h"

#include "tests/unit/inspect/sloped_seam.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

using test::SeamSlope;
using test::SlopedSeam;

std::vector<SeamPart> partitioned(const SeamSlope& slope) {
    const SlopedSeam seam(slope);
    return partition_seam(seam.probes().front(), 7, {});
}

TEST(PartitionSeam, LeavesASeamOfOneClassWhole) {
    for (const double angle : {0.0, 4.9999, 5.0001, 40.0}) {
        const auto parts = partitioned({{{100, {angle, angle, angle, angle}}}});
        ASSERT_EQ(parts.size(), 1u);
        EXPECT_EQ(parts[0].kind, angle > 5 ? SeamClass::crease : SeamClass::smooth);
        EXPECT_EQ(parts[0].piece, 7u);
        EXPECT_NEAR(parts[0].length, 100, 1e-9);
        EXPECT_EQ(parts[0].unknown, 0);
    }
}

TEST(PartitionSeam, CutsWhereTheAnglePassesTheFeatureAngle) {
    const SeamSlope slope{{{100, {1, 3, 14, 12}}, {250, {12, 9, 2, 0}}}};
    const auto parts = partitioned(slope);
    ASSERT_EQ(parts.size(), 3u);
    EXPECT_EQ(parts[1].kind, SeamClass::crease);
    EXPECT_NEAR(parts[1].begin.place.x, slope.place_of(5, 0, 100), 2 * class_change_bound);
    EXPECT_NEAR(parts[1].end.place.x, slope.place_of(5, 100, 250), 2 * class_change_bound);
    double length = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        length += parts[i].length;
        EXPECT_NEAR(parts[i].begin.t, i > 0 ? parts[i - 1].end.t : 0, 1e-8);
    }
    EXPECT_NEAR(length, 250, 4 * class_change_bound);
}

TEST(PartitionSeam, FindsAPeakBetweenItsSteps) {
    // A cubic peaks at its middle with 3/4 of the control value, over the limit for 5 to 15 mm.
    for (const double control : {6.67, 6.7, 7.0}) {
        const SeamSlope slope{{{300, {0, control, control, 0}}}};
        const auto parts = partitioned(slope);
        ASSERT_EQ(parts.size(), 3u) << control;
        EXPECT_NEAR(parts[1].begin.place.x, slope.place_of(5, 0, 150), 1e-5);
        EXPECT_NEAR(parts[1].end.place.x, slope.place_of(5, 150, 300), 1e-5);
    }
    EXPECT_EQ(partitioned({{{300, {0, 6.63, 6.63, 0}}}}).size(), 1u);
}

} // namespace
} // namespace keiko
