#include "keiko/inspect/seams/run_out.h"

#include "tests/unit/inspect/sloped_seam.h"
#include <gtest/gtest.h>

#include <algorithm>

namespace keiko {
namespace {

using test::SeamSlope;
using test::SlopedSeam;

std::optional<RunOut> followed(const SlopedSeam& seam, const StretchLimits& limits = {},
                               bool forward = true) {
    const auto parts = partition_seam(seam.probes().front(), 0, limits);
    const auto crease = std::find_if(parts.begin(), parts.end(), [](const SeamPart& part) {
        return part.kind == SeamClass::crease;
    });
    if (crease == parts.end()) return std::nullopt;
    return follow_run_out(seam.probes(), parts, static_cast<std::size_t>(crease - parts.begin()),
                          forward, limits);
}

/// A crease of 8 degrees for 100 mm that fades to nothing over 60 mm, its slope on the way out and
/// in by the cubic's control values.
SeamSlope fading(double second, double third) {
    return {{{100, {8, 8, 8, 8}}, {160, {8, second, third, 0}}, {260, {0, 0, 0, 0}}}};
}
const SeamSlope smooth_fade = fading(8, 0);

TEST(FollowRunOut, EndsWhereTheAngleFallsToItsLimit) {
    const StretchLimits limits;
    const auto found = followed(SlopedSeam(smooth_fade));
    ASSERT_TRUE(found);
    const double begin = smooth_fade.place_of(limits.feature_angle, 100, 160);
    const double end = smooth_fade.place_of(limits.angle, 100, 160);
    EXPECT_NEAR(found->length(), end - begin, 1e-5);
    ASSERT_EQ(found->pieces.size(), 1u);
    EXPECT_EQ(found->pieces[0].taken.kind, SeamClass::run_out);
    EXPECT_NEAR(found->pieces[0].taken.end.place.x, end, 1e-5);
    ASSERT_TRUE(found->pieces[0].left);
    EXPECT_NEAR(found->pieces[0].left->length, 260 - end, 1e-5);
    EXPECT_LT(found->step.value + found->step.bound, 1e-3);
    EXPECT_EQ(found->step.verdict, Verdict::pass);
}

TEST(FollowRunOut, FollowsTheSeamEitherWay) {
    const SeamSlope reversed{{{100, {0, 0, 0, 0}}, {160, {0, 0, 8, 8}}, {260, {8, 8, 8, 8}}}};
    const SlopedSeam seam(reversed);
    EXPECT_NEAR(followed(seam, {}, false).value().length(),
                followed(SlopedSeam(smooth_fade)).value().length(), 1e-5);
    EXPECT_FALSE(followed(seam, {}, true)); // there the crease goes on to the seam's end
}

TEST(FollowRunOut, MeasuresTheStepOfTheSlope) {
    for (const double third : {8.0 / 3, 1.0, 0.1}) {
        const auto found = followed(SlopedSeam(fading(8, third)));
        ASSERT_TRUE(found);
        // From the cubic's end to the plane.
        const double step = radians_to_degrees(SeamSlope::tangent(third)) * 3 / 60;
        EXPECT_NEAR(found->step.value, step, found->step.bound + 1e-4 * step);
        EXPECT_LT(found->step.bound, 1e-3 * step + 1e-5);
        EXPECT_NEAR(found->step.place.x, 160, 1e-6);
        EXPECT_EQ(found->step.verdict, Verdict::fail);
    }
}

TEST(FollowRunOut, MeasuresTheSameWhereABorderEndsJustBefore) {
    const SlopedSeam seam(smooth_fade);
    const SeamProbe& probe = seam.probes().front();
    const auto parts = partition_seam(probe, 0, {});
    ASSERT_EQ(parts.front().kind, SeamClass::crease);
    const double cut = parts.front().end.t - 0.1 / 260; // 0.1 mm before the end
    std::vector<SeamPart> divided = parts;
    divided.insert(divided.begin(), parts.front());
    divided[0].end = divided[1].begin = probe.at(cut);
    for (SeamPart& part : divided) part.length = probe.part(part.begin, part.end).length();
    const auto whole = follow_run_out(seam.probes(), parts, 0, true, {});
    const auto halves = follow_run_out(seam.probes(), divided, 1, true, {});
    ASSERT_TRUE(whole && halves);
    EXPECT_LE(halves->step.value, halves->step.bound); // the fade has no corner
    EXPECT_LT(halves->step.bound, 2 * whole->step.bound);
}

TEST(FollowRunOut, IsNoneWhereTheAngleStaysOverItsLimit) {
    for (const double rest : {0.11, 0.5, 4.0}) {
        const SeamSlope plateau{
            {{100, {8, 8, 8, 8}}, {160, {8, 8, rest, rest}}, {260, {rest, rest, rest, rest}}}};
        EXPECT_FALSE(followed(SlopedSeam(plateau))) << rest;
    }
}

TEST(FollowRunOut, IsNoneWhereTheAngleRisesByMoreThanItsLimit) {
    const auto dipping = [](double rise) {
        // A cubic between flat ends falls to 1 degree, the next one rises, the last one falls.
        return SeamSlope{{{100, {8, 8, 8, 8}},
                          {160, {8, 8, 1, 1}},
                          {200, {1, 1, 1 + rise, 1 + rise}},
                          {240, {1 + rise, 1 + rise, 0, 0}},
                          {300, {0, 0, 0, 0}}}};
    };
    EXPECT_TRUE(followed(SlopedSeam(dipping(0.098))));
    EXPECT_FALSE(followed(SlopedSeam(dipping(0.102))));
}

TEST(FollowRunOut, IsNoLongerThanTheLimitAllows) {
    const double length = followed(SlopedSeam(smooth_fade)).value().length();
    EXPECT_TRUE(followed(SlopedSeam(smooth_fade), {.longest_run_out = length + 0.2}));
    EXPECT_FALSE(followed(SlopedSeam(smooth_fade), {.longest_run_out = length - 0.2}));
}

TEST(FollowRunOut, NeverPassesACorner) {
    // Halfway through the fade the seam turns; the angle goes on as before.
    const SeamSlope halves{
        {{100, {8, 8, 8, 8}}, {130, {8, 8, 6, 4}}, {160, {4, 2, 0, 0}}, {260, {0, 0, 0, 0}}}};
    EXPECT_TRUE(followed(SlopedSeam(halves)));
    EXPECT_TRUE(followed(SlopedSeam(halves, 130, 14.5)));
    EXPECT_FALSE(followed(SlopedSeam(halves, 130, 15.5)));
    EXPECT_FALSE(followed(SlopedSeam(halves, 130, 45)));
}

TEST(FollowRunOut, EndsAtACornerBeyondIt) {
    // The angle is down when the seam turns. What comes behind is another line.
    const SeamSlope behind{
        {{100, {8, 8, 8, 8}}, {160, {8, 8, 0, 0}}, {160.3, {0, 0, 0, 0}}, {200, {0, 1, 1, 1}}}};
    EXPECT_EQ(followed(SlopedSeam(behind)).value().step.verdict, Verdict::fail);
    const auto found = followed(SlopedSeam(behind, 160.3, 20));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->step.verdict, Verdict::pass);
}

} // namespace
} // namespace keiko
