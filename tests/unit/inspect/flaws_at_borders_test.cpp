#include "tests/unit/inspect/flawed_sheets.h"
#include <gtest/gtest.h>

#include <cmath>

namespace keiko {
namespace {

using test::bump, test::checks_of_flaws, test::everywhere, test::half_sheet, test::Polynomial,
    test::Profile, test::sheet, test::SheetForm, test::wave;

/// Convex and saddle; so flat at their ends that what is planted along z is as deep along the
/// normal.
constexpr std::array<SheetForm, 2> forms{{{-1e-3, -2e-4}, {5e-4, -1e-3}}};
SheetForm flattened(const SheetForm& form, double half) {
    const double share = 20 / half;
    return {form.bend_x * share, form.bend_y * share};
}

/// Holds a flaw of a depth, across the surface, against a limit that is 3 % less: one finding.
Vec3 place_of_finding(const SurfaceModel& model, double depth, double window, const char* code) {
    const std::vector<Check> checks = checks_of_flaws(model, 0.97 * depth, window);
    std::vector<Check> flaws;
    std::copy_if(checks.begin(), checks.end(), std::back_inserter(flaws),
                 [](const Check& check) { return check.worst.value > 0; });
    EXPECT_EQ(flaws.size(), 1u);
    if (flaws.size() != 1) return Vec3(0);
    EXPECT_EQ(flaws[0].code, code);
    EXPECT_NEAR(flaws[0].worst.value, depth, 0.01 * depth) << flaws[0].message;
    EXPECT_EQ(flaws[0].worst.verdict, Verdict::fail) << flaws[0].worst.bound;
    EXPECT_EQ(judge(flaws[0].worst.value, flaws[0].worst.bound, 1.03 * depth), Verdict::pass);
    return flaws[0].worst.place;
}

/// A depth and the form that it is planted in.
struct Planted {
    double depth; ///< mm
    SheetForm form;
};
constexpr std::array<Planted, 3> planted{{{0.001, forms[0]}, {0.03, forms[1]}, {1, forms[0]}}};

TEST(FlawsAtBorders, DentsOnSeamsAreMeasuredOverThem) {
    for (const auto& [depth, form] : planted)
        for (const double radius : {10.0, 25.0})
            for (const double off : {0.0, 0.5}) { // of the radius, from the seam
                SCOPED_TRACE(testing::Message() << radius << ' ' << off << ' ' << depth);
                const SurfaceModel model =
                    sheet(bump(21, radius), bump(-33, radius), -depth, form, {21 - off * radius});
                const Vec3 place = place_of_finding(model, depth, 100, "KEIKO-DENT");
                EXPECT_NEAR(place.x, 21, 0.5);
                EXPECT_NEAR(place.y, -33, 0.5);
            }
}

TEST(FlawsAtBorders, DentsCutByBordersAreMeasuredFromOneSide) {
    for (const auto& [depth, form] : planted)
        for (const double radius : {10.0, 15.0})
            for (const double off : {0.0, 0.5, 0.9}) { // of the radius, from the border
                SCOPED_TRACE(testing::Message() << radius << ' ' << off << ' ' << depth);
                const double centre = half_sheet - off * radius;
                const Profile across = test::part(bump(centre, radius), -half_sheet, half_sheet);
                const SurfaceModel model =
                    sheet(across, bump(7, radius), -depth, flattened(form, half_sheet));
                const Vec3 place = place_of_finding(model, depth, 100, "KEIKO-DENT");
                EXPECT_NEAR(place.x, centre, 0.5);
                EXPECT_NEAR(place.y, 7, 0.5);
            }
}

/// A rim between a dent and its border bends as a crest of waves does; beside it fewer samples than
/// it takes show how deep the dent is.
TEST(FlawsAtBorders, DentsBesideBordersAreMeasuredWhereverTheirRimEnds) {
    const SheetForm form = flattened(forms[0], half_sheet);
    for (const double radius : {10.0, 15.0})
        for (const double depth : {0.1, 1.0})
            for (const double off : {0.2, 0.4, 0.6, 0.7, 0.8, 1.0, 1.1, 1.3}) { // of the radius
                SCOPED_TRACE(testing::Message() << radius << ' ' << off << ' ' << depth);
                const double centre = half_sheet - off * radius, y = 7 - 30 * off;
                const Profile across =
                    test::part(bump(centre, radius, half_sheet + radius), -half_sheet, half_sheet);
                const Vec3 place = place_of_finding(sheet(across, bump(y, radius), -depth, form),
                                                    depth, 100, "KEIKO-DENT");
                EXPECT_NEAR(place.x, centre, 0.5);
                EXPECT_NEAR(place.y, y, 0.5);
            }
}

/// The deepest place of the face is then on the border.
TEST(FlawsAtBorders, DentsWithTheirMiddleBeyondABorderAreFound) {
    const SheetForm form = flattened(forms[0], half_sheet);
    for (const double radius : {10.0, 12.0, 15.0})
        for (const double depth : {0.1, 1.0})
            for (const double off : {0.1, 0.25, 0.4}) { // of the radius
                SCOPED_TRACE(testing::Message() << radius << ' ' << off << ' ' << depth);
                const Profile across =
                    test::part(bump(half_sheet + off * radius, radius, half_sheet + 2 * radius),
                               -half_sheet, half_sheet);
                const auto checks =
                    checks_of_flaws(sheet(across, bump(9.6, radius), -depth, form), 0.01);
                ASSERT_EQ(checks.size(), 1u);
                const double there = depth * std::pow(1 - off * off, 4);
                EXPECT_EQ(checks[0].code, "KEIKO-DENT");
                EXPECT_EQ(checks[0].worst.verdict, Verdict::fail);
                EXPECT_NEAR(checks[0].worst.value, there, 0.03 * there);
            }
}

/// mm: two waves fit in, and waves of 1 mm are no form to it.
double window_for(double length) {
    return std::max(2 * length, 60.0);
}
constexpr std::array lengths{20.0, 50.0, 100.0, 200.0}; ///< mm
/// mm: deeper ones are form to that window.
double depth_for(double deepest, double length) {
    return std::min(deepest, 0.9 * window_for(length) / 50);
}
/// Expects a place of waves along x to be a crest or trough, by its distance from the one next to
/// it.
void expect_crest(const Vec3& place, double length) {
    const double off = std::abs(std::remainder(place.x, length / 2)) - length / 4;
    EXPECT_NEAR(off, 0, 0.02 * length);
}

/// Strips a wave wide, which show it together alone; crests, or what is between crest and trough,
/// fall on seams.
TEST(FlawsAtBorders, WavesOverSeamsAreMeasuredOverThem) {
    for (const auto& [deepest, form] : planted)
        for (const double length : lengths)
            for (const double phase : {0.25, 0.4}) {
                const double depth = depth_for(deepest, length), half = 2 * length;
                SCOPED_TRACE(testing::Message() << length << ' ' << depth << ' ' << phase);
                std::vector<double> cuts;
                for (const double wave : {-1, 0, 1}) cuts.push_back((wave + phase) * length);
                const SurfaceModel model = sheet(wave(length, half), everywhere(length), depth,
                                                 flattened(form, half), cuts);
                expect_crest(place_of_finding(model, depth, window_for(length), "G-SU-WV"), length);
            }
}

/// Flat profile, then half waves that begin softly and end at the border in a crest or between two.
Profile train(double length, double halves, double half) {
    const double extent = length / 2;
    Profile p{{-half, half - (halves + 1) * extent}, {{}}};
    // t^3 (a + b t + c t^2) from 0 to where the first half wave begins
    const Polynomial onset{0, 0, 0, -12.8, 22.4, -9.6};
    Polynomial middle = test::shifted(onset, 0.5);
    for (std::size_t k = 0; k < middle.size(); ++k)
        middle[k] /= std::pow(extent, static_cast<double>(k));
    p.knots.push_back(p.knots.back() + extent), p.pieces.push_back(middle);
    for (double k = 0, sign = 1; k < halves; ++k, sign = -sign) {
        const double q = sign / (extent * extent);
        p.knots.push_back(p.knots.back() + extent);
        p.pieces.push_back({sign, 0, -4.8 * q, 0, 3.2 * q / (extent * extent)});
    }
    return test::part(p, -half, half);
}

TEST(FlawsAtBorders, WavesThatEndAtABorderAreMeasuredFromOneSide) {
    for (const auto& [deepest, form] : planted)
        for (const double length : lengths)
            for (const double halves : {5.0, 5.5}) {
                const double depth = depth_for(deepest, length), half = 2 * length;
                SCOPED_TRACE(testing::Message() << length << ' ' << depth << ' ' << halves);
                const SurfaceModel model = sheet(train(length, halves, half), everywhere(length),
                                                 depth, flattened(form, half));
                const Vec3 place = place_of_finding(model, depth, window_for(length), "G-SU-WV");
                EXPECT_GT(place.x, half - (halves + 0.5) * length / 2);
            }
}

/// Waves as a trimmed edge has them: highest at the border, gone a wave and a half further in.
TEST(FlawsAtBorders, WavesAlongABorderAreMeasuredAtIt) {
    for (const auto& [deepest, form] : planted)
        for (const double length : lengths) {
            const double depth = depth_for(deepest, length), half = 2 * length;
            SCOPED_TRACE(testing::Message() << length << ' ' << depth);
            const Profile fading = test::part(bump(half, 1.5 * length, half), -half, half);
            const SurfaceModel model =
                sheet(wave(length, half), fading, depth, flattened(form, half));
            const Vec3 place = place_of_finding(model, depth, window_for(length), "G-SU-WV");
            EXPECT_NEAR(place.y, half, 0.02 * length);
            expect_crest(place, length);
        }
}

TEST(FlawsAtBorders, NothingIsFoundOnTheCleanTwins) {
    for (const SheetForm& form : forms)
        for (const double limit : {1e-5, 1e-2}) {
            const Profile clean = everywhere();
            for (const Check& check :
                 checks_of_flaws(sheet(clean, clean, 0, form, {-40, 21, 60}), limit))
                EXPECT_EQ(check.worst.value, 0) << check.message;
        }
}

/// How wide a dent a window of 100 mm measures (docs/theory/verdict.md): wider ones are undecided
/// or not seen, never measured wrongly.
TEST(FlawsAtBorders, WhatIsTooWideForTheWindowIsNotMeasuredWrongly) {
    const SheetForm flat{};
    const auto checks_of = [&](double centre, double diameter) {
        const Profile across = test::part(bump(centre, diameter / 2), -half_sheet, half_sheet);
        return checks_of_flaws(sheet(across, bump(7, diameter / 2), -0.1, flat), 0.01);
    };
    for (const auto& [centre, widest] : {std::pair(0.0, 80.0), std::pair(half_sheet - 1, 80.0)})
        for (double diameter = 20; diameter <= 120; diameter += 10)
            for (const Check& check : checks_of(centre, diameter)) {
                SCOPED_TRACE(testing::Message() << centre << ' ' << diameter);
                const bool right = std::abs(check.worst.value - 0.1) <= 0.001;
                if (diameter <= widest)
                    EXPECT_TRUE(right) << check.message;
                else
                    EXPECT_TRUE(right || check.worst.bound > 0.1 * check.worst.value ||
                                check.worst.value == 0)
                        << check.message;
            }
}

/// One and a half to two and a half waves from border to border may be form.
TEST(FlawsAtBorders, WavesAcrossANarrowStripAreUndecided) {
    for (const double waves : {1.5, 2.0})
        for (const double length : {20.0, 40.0})
            for (const double depth : {0.02, 0.03}) {
                SCOPED_TRACE(testing::Message() << waves << ' ' << length << ' ' << depth);
                const double half = waves * length / 2;
                const Profile across = test::part(wave(length, 3 * length), -half, half);
                const std::vector<Check> checks =
                    checks_of_flaws(sheet(across, everywhere(), depth, {}), 0.01);
                ASSERT_EQ(checks.size(), 1u);
                EXPECT_EQ(checks[0].code, "G-SU-WV");
                EXPECT_EQ(checks[0].worst.verdict, Verdict::undecided);
                EXPECT_NEAR(checks[0].worst.value, depth, 0.1 * depth);
                EXPECT_LT(checks[0].worst.bound, 0.1 * depth);
                EXPECT_NE(checks[0].message.find("may be form"), std::string::npos);
            }
}

TEST(FlawsAtBorders, AFaceOfKilometresIsUndecided) {
    test::ModelBuilder builder;
    builder.plane({0, 0, 0}, {3e7, 0, 0}, {0, 3e7, 0});
    const std::vector<Check> checks = checks_of_flaws(builder.build(), 0.01);
    ASSERT_EQ(checks.size(), 1u);
    EXPECT_EQ(checks[0].worst.verdict, Verdict::undecided);
    EXPECT_NE(checks[0].message.find("too large"), std::string::npos);
    EXPECT_NE(checks[0].message.find("some 4.24e+07 mm in size"), std::string::npos);
}

} // namespace
} // namespace keiko
