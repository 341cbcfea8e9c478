#include "keiko/inspect/seams/seam_profile.h"

#include "keiko/base/units.h"
#include "keiko/files/scene/preset_file.h"
#include "keiko/import/worker/load_model.h"
#include "keiko/inspect/inspection.h"

#include "tests/support/paths.h"
#include "tests/unit/inspect/fading_defects.h"
#include "tests/unit/inspect/sheets.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numeric>

namespace keiko {
namespace {

using test::FadingDefect;

constexpr double bend = 1 / test::defect_radius;

struct Profiled {
    Inspection inspection;
    std::vector<SeamProfile> profiles;

    const SeamProfile& only() const {
        EXPECT_EQ(profiles.size(), 1u);
        return profiles.at(0);
    }
};

Profiled profiled(const SurfaceModel& model, const CriteriaPreset& preset = {}) {
    Profiled result{inspect(model, preset), {}};
    std::vector<std::uint32_t> all(result.inspection.seams.size());
    std::iota(all.begin(), all.end(), 0u);
    result.profiles =
        seam_profiles(model, result.inspection.seams, result.inspection.pieces, all, preset);
    return result;
}

SurfaceModel sheets(const FadingDefect& defect) {
    test::ModelBuilder builder;
    test::add_sheet(builder, -test::defect_length, bend, {});
    test::add_sheet(builder, 0, bend, defect);
    return builder.build();
}

/// The share of a defect's largest value that is left at a place of the seam.
double fading(double y) {
    return 1 - (y - test::defect_place) * (y - test::defect_place) / 1e4;
}

/// Share of the seam along which a quantity of this largest value exceeds its limit.
double share_above(double limit, double largest) {
    if (largest <= limit) return 0;
    const double half = 100 * std::sqrt(1 - limit / largest);
    return (std::min(100.0, test::defect_place + half) - std::max(0.0, test::defect_place - half)) /
           100;
}

/// Mismatch by Alias's formula where the right curvature is larger by `more`.
double alias(double more) {
    return more / (2 * bend + more);
}

TEST(SeamProfiles, FollowClosedFormsAllAlong) {
    const double slope = std::tan(degrees_to_radians(0.08)), more = 0.0004;
    const SeamProfile profile = profiled(sheets({.slope = slope, .curvature = more})).only();
    EXPECT_NEAR(profile.length, 100, 1e-9);
    for (const ProfileSample& s : profile.samples) {
        const double y = s.point.place.y, tilt = slope * fading(y);
        EXPECT_NEAR(s.along, std::abs(y - profile.samples.front().point.place.y), 1e-9);
        EXPECT_NEAR(s.point.gap, 0, 1e-12);
        EXPECT_NEAR(s.point.angle.value(), radians_to_degrees(std::atan(tilt)), 1e-9);
        const double right = (bend + more * fading(y)) / std::pow(1 + tilt * tilt, 1.5);
        EXPECT_NEAR(std::abs(s.point.curvature_a), bend, 1e-12);
        EXPECT_NEAR(std::abs(s.point.curvature_b), right, 1e-12);
        EXPECT_NEAR(s.alias, (right - bend) / (right + bend), 1e-9);
        EXPECT_NEAR(s.catia, (right - bend) / right, 1e-9);
        EXPECT_EQ(s.mismatch, s.alias);
    }
}

TEST(SeamProfiles, ShowCurvatureWhereTheAngleFails) {
    const FadingDefect defect{.slope = std::tan(degrees_to_radians(0.3)), .curvature = 0.0005};
    const Profiled found = profiled(sheets(defect));
    EXPECT_FALSE(found.inspection.seams.at(0).curvature);
    const ProfileQuantity curvature = found.only().curvature.value();
    EXPECT_FALSE(curvature.judged);
    EXPECT_EQ(curvature.limit, 0.1);
    EXPECT_NEAR(curvature.largest, alias(0.0005), 1e-4);
    EXPECT_NEAR(curvature.place.y, test::defect_place, 0.1);
    EXPECT_GT(curvature.beyond.value, 0);
    EXPECT_TRUE(found.only().angle->judged);
}

void expect_share(const ProfileQuantity& quantity, double expected) {
    EXPECT_NEAR(quantity.beyond.value, expected, quantity.beyond.bound + 1e-9);
    EXPECT_NEAR(quantity.beyond.value, expected, 1e-5);
    EXPECT_LE(quantity.beyond.bound, 2.1e-3);
}

TEST(SeamProfiles, ShareBeyondTheLimitIsThatOfTheClosedForm) {
    for (const double times : {0.5, 0.99, 1.01, 1.1, 2.0, 10.0, 40.0}) {
        SCOPED_TRACE(times);
        const double gap = 0.01 * times;
        expect_share(*profiled(sheets({.gap = gap})).only().gap, share_above(0.01, gap));
        const double angle = 0.1 * times;
        const double slope = std::tan(degrees_to_radians(angle));
        expect_share(*profiled(sheets({.slope = slope})).only().angle, share_above(0.1, angle));
        // A mismatch of 0.1 is 2 / 9 more curvature.
        const double more = 2.0 / 9 * bend;
        expect_share(*profiled(sheets({.curvature = more * times})).only().curvature,
                     share_above(more, more * times));
    }
}

TEST(SeamProfiles, OfALineOverItsLimitAllAlongIsWholeAndOfOneBelowNone) {
    test::ModelBuilder builder;
    flat_sheet(builder, {0, 50, 0}, {0, 0.02, 0});
    flat_sheet(builder, {0, -50, 0});
    const SeamProfile profile = profiled(builder.build()).only();
    EXPECT_NEAR(profile.gap->beyond.value, 1, 1e-12);
    EXPECT_EQ(profile.gap->beyond.bound, 0);
    EXPECT_EQ(profile.angle->beyond.value, 0);
    EXPECT_LT(profile.samples.size(), 30u);
}

/// The first sample at a place, as far as one is there.
bool has_sample(const SeamProfile& profile, const ProfileQuantity& quantity) {
    return std::any_of(profile.samples.begin(), profile.samples.end(), [&](const auto& s) {
        return s.along == quantity.along && (s.point.place - quantity.place).length() == 0;
    });
}

void expect_agrees(const SeamProfile& profile, const std::optional<ProfileQuantity>& quantity,
                   const MeasuredValue& verdict) {
    ASSERT_TRUE(quantity);
    EXPECT_NEAR(quantity->largest, verdict.value, quantity->bound + verdict.bound);
    EXPECT_TRUE(has_sample(profile, *quantity));
    EXPECT_GE(quantity->along, 0);
    EXPECT_LE(quantity->along, profile.length * (1 + 1e-9));
}

/// Each value of the verdict is that of the profile, and no sample exceeds it and its bound.
void expect_verdicts_agree(const Profiled& found) {
    for (const SeamProfile& profile : found.profiles) {
        const MeasuredSeam& seam = found.inspection.seams[profile.seam];
        SCOPED_TRACE(seam.faces);
        EXPECT_NEAR(profile.length, seam.length, 1e-6 * seam.length + 1e-9);
        if (!profile.gap) continue;
        expect_agrees(profile, profile.gap, seam.gap);
        if (seam.angle) expect_agrees(profile, profile.angle, *seam.angle);
        if (seam.curvature) expect_agrees(profile, profile.curvature, seam.curvature->worst);
        if (seam.slope) expect_agrees(profile, profile.slope, seam.slope->worst);
        for (const ProfileSample& s : profile.samples) {
            EXPECT_LE(s.point.gap, seam.gap.value + seam.gap.bound + 1e-9);
            if (seam.angle && s.point.angle) {
                EXPECT_LE(*s.point.angle, seam.angle->value + seam.angle->bound + 1e-7);
            }
        }
        EXPECT_TRUE(std::is_sorted(
            profile.samples.begin(), profile.samples.end(),
            [](const ProfileSample& a, const ProfileSample& b) { return a.along < b.along; }));
        EXPECT_EQ(profile.samples.front().along, 0);
        EXPECT_NEAR(profile.samples.back().along, profile.length, 1e-6 * profile.length + 1e-9);
    }
}

TEST(SeamProfiles, LargestValuesAreThoseOfTheVerdictsOfEveryPreset) {
    for (const CriteriaPreset& preset : standard_presets())
        for (const FadingDefect& defect :
             {FadingDefect{}, FadingDefect{.gap = 0.05}, FadingDefect{.slope = 0.01},
              FadingDefect{.curvature = 0.0005}, FadingDefect{.change = 1e-6},
              FadingDefect{.slope = 0.2}}) {
            SCOPED_TRACE(preset.name);
            expect_verdicts_agree(profiled(sheets(defect), preset));
        }
}

TEST(SeamProfiles, HaveOnlyTheLimitsOfTheirClass) {
    const Profiled found = profiled(sheets({.slope = 0.2}));
    std::size_t creases = 0;
    for (const SeamProfile& profile : found.profiles) {
        const MeasuredSeam& seam = found.inspection.seams[profile.seam];
        EXPECT_EQ(profile.gap->limit, 0.01);
        if (seam.kind != SeamClass::crease) continue;
        ++creases;
        EXPECT_FALSE(profile.angle->limit);
        EXPECT_FALSE(profile.curvature->limit);
        EXPECT_EQ(profile.angle->beyond.value, 0);
        EXPECT_GT(profile.angle->largest, 5);
    }
    EXPECT_GT(creases, 0u);
}

TEST(SeamProfiles, SlopeHasALimitOnlyWhereThePresetHasOne) {
    CriteriaPreset preset;
    const SurfaceModel model = sheets({.change = 1e-7});
    EXPECT_FALSE(profiled(model, preset).only().slope->limit);
    preset.curvature_slope = 0.1;
    const ProfileQuantity slope = profiled(model, preset).only().slope.value();
    EXPECT_EQ(slope.limit, 0.1);
    EXPECT_TRUE(slope.judged);
    EXPECT_NEAR(slope.largest, radians_to_degrees(std::atan(0.1)), 1e-6);
    expect_share(slope, share_above(std::tan(degrees_to_radians(0.1)), 0.1));
}

class ProfilesOfModels : public testing::TestWithParam<const char*> {};

TEST_P(ProfilesOfModels, HaveTheLargestValuesOfTheVerdicts) {
    KEIKO_NEEDS_SHARED_MODEL(GetParam());
    const Profiled found = profiled(load_model(test::shared_model(GetParam())));
    std::size_t samples = 0;
    for (const SeamProfile& profile : found.profiles) samples += profile.samples.size();
    std::cout << GetParam() << ": " << found.profiles.size() << " profiles, " << samples
              << " samples\n";
    EXPECT_EQ(found.profiles.size(), found.inspection.seams.size());
    expect_verdicts_agree(found);
}

INSTANTIATE_TEST_SUITE_P(Shared, ProfilesOfModels,
                         testing::Values("car-hood.brep", "car-hood-converted.step",
                                         "car-front-fender.brep"));

} // namespace
} // namespace keiko
