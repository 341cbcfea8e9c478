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

TEST(PartitionSeam, KnowsTheEndsOfAPeak) {
    for (const double control : {6.67, 6.7, 7.0}) {
        const SeamSlope slope{{{300, {0, control, control, 0}}}};
        const auto parts = partitioned(slope);
        ASSERT_EQ(parts.size(), 3u) << control;
        EXPECT_NEAR(parts[1].begin.place.x, slope.place_of(5, 0, 150), 1e-5);
        EXPECT_NEAR(parts[1].end.place.x, slope.place_of(5, 150, 300), 1e-5);
    }
}

/// A peak of an angle that is 0 at both ends of the seam.
struct Peak {
    SeamSlope slope;
    double place = 0; ///< mm
};

/// A cubic of 300 mm that peaks with `degrees` where its inner control values have the ratio
/// `lean`.
Peak peak_of(double lean, double degrees) {
    const auto scaled = [&](double scale) {
        const double inner = radians_to_degrees(std::atan(scale));
        const double other = radians_to_degrees(std::atan(scale * lean));
        return SeamSlope{{{300, {0, inner, other, 0}}}};
    };
    // Where the derivative of u (1 - u)^2 + lean u^2 (1 - u) is 0.
    const double a = 3 - 3 * lean, b = 2 * lean - 4;
    const double u = a == 0 ? 0.5 : (-b - std::sqrt(b * b - 4 * a)) / (2 * a);
    const double share = SeamSlope::tangent(scaled(1).angle(300 * u));
    return {scaled(SeamSlope::tangent(degrees) / share), 300 * u};
}

/// Whether an end or a middle of the search's first steps lies over the feature angle.
bool is_over_at_first_steps(const SeamProbe& probe, const SeamSlope& slope) {
    const auto over = [&](double t) { return slope.angle(probe.place(t).x) > 5; };
    const std::vector<SeamStep> steps = probe.steps(16);
    bool any = over(steps.front().t);
    for (std::size_t i = 1; i < steps.size(); ++i)
        any = any || over(steps[i].t) || over((steps[i - 1].t + steps[i].t) / 2);
    return any;
}

TEST(PartitionSeam, FindsEveryPeakBetweenItsFirstSteps) {
    int between = 0;
    for (const double over : {1e-4, 1e-3, 1e-2})
        for (double lean = 0.02; lean < 50; lean *= 1.07) {
            const Peak peak = peak_of(lean, 5 + over);
            ASSERT_NEAR(peak.slope.angle(peak.place), 5 + over, 1e-9);
            const SlopedSeam seam(peak.slope);
            if (is_over_at_first_steps(seam.probes().front(), peak.slope)) continue;
            ++between;
            const auto parts = partition_seam(seam.probes().front(), 0, {});
            ASSERT_EQ(parts.size(), 3U) << lean << ", " << over;
            EXPECT_EQ(parts[1].kind, SeamClass::crease);
            // Angles nearer to each other than 1e-8 degrees are not distinguished.
            EXPECT_NEAR(peak.slope.angle(parts[1].begin.place.x), 5, 2e-8) << lean << ", " << over;
            EXPECT_NEAR(peak.slope.angle(parts[1].end.place.x), 5, 2e-8) << lean << ", " << over;
            EXPECT_EQ(partitioned(peak_of(lean, 5 - over).slope).size(), 1U) << lean;
        }
    EXPECT_GT(between, 200);
}

} // namespace
} // namespace keiko
