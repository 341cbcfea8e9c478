#include "keiko/inspect/seams/scraps.h"

#include "keiko/base/units.h"
#include "keiko/inspect/seams/seam_measure.h"

#include "tests/support/model_builder.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace keiko {
namespace {

Scrap scrap(std::uint32_t face_a, std::uint32_t face_b, double length) {
    return {{{{0, face_a}, {0, face_b}}}, length, 0.1, {}};
}

/// A scrap on a line from one place to another, of faces of its own.
Scrap line(std::uint32_t number, const Vec3& from, const Vec3& to) {
    Scrap result = scrap(2 * number, 2 * number + 1, (to - from).length());
    result.tips = {{from, from - to, from - to}, {to, to - from, to - from}};
    return result;
}

using Flags = std::vector<bool>;
constexpr double reach = 0.5; ///< mm

TEST(JudgedScraps, AreNoneOfAFaceUpToTheNegligibleLength) {
    EXPECT_EQ(judged_scraps(std::vector{scrap(0, 1, 0.05), scrap(0, 2, 0.04)}, reach),
              (Flags{false, false}));
    EXPECT_TRUE(judged_scraps({}, reach).empty());
}

TEST(JudgedScraps, AreThoseOfAFaceThatAreTogetherLonger) {
    // Face 0 has 0.11 mm, face 3 has 0.06.
    EXPECT_EQ(
        judged_scraps(std::vector{scrap(0, 1, 0.06), scrap(2, 0, 0.05), scrap(3, 5, 0.06)}, reach),
        (Flags{true, true, false}));
}

TEST(JudgedScraps, AreCountedForEachPlacedFaceAlone) {
    std::vector<Scrap> scraps{scrap(0, 1, 0.06), scrap(0, 1, 0.06)};
    for (PlacedFace& face : scraps[1].faces) face.instance = 1;
    EXPECT_EQ(judged_scraps(scraps, reach), (Flags{false, false}));
    EXPECT_EQ(judged_scraps(std::vector{scrap(0, 0, 0.06)}, reach), Flags{false}); // counted once
}

TEST(JudgedScraps, AreThoseThatContinueEachOtherAcrossFaces) {
    const Scrap first = line(0, {0, 0, 0}, {0.06, 0, 0});
    for (const Scrap& next : {line(1, {0.06, 0, 0}, {0.12, 0, 0}), // end to end
                              line(1, {0.12, 0, 0}, {0.06, 0, 0}), // run backwards
                              line(1, {0.5, 0, 0}, {0.56, 0, 0})}) // within the join distance
        EXPECT_EQ(judged_scraps(std::vector{first, next}, reach), (Flags{true, true}));
    for (const Scrap& apart : {line(1, {0.06, 0, 0}, {0.06, 0.06, 0}), // around a corner
                               line(1, {0.06, 0, 0}, {0, 0.001, 0}),   // back again
                               line(1, {0, 0.05, 0}, {0.06, 0.05, 0}), // beside it
                               line(1, {0.6, 0, 0}, {0.66, 0, 0})})    // too far away
        EXPECT_EQ(judged_scraps(std::vector{first, apart}, reach), (Flags{false, false}));
}

/// Verdict on all seams of a model, whose borders are joined within `join` mm.
Verdict verdict_of_seams(const SurfaceModel& model, double join) {
    Verdict verdict = Verdict::pass;
    for (const MeasuredSeam& seam : measure_seams(model, pair_seams(model, join), {}, join).seams)
        verdict = std::max(verdict, seam.verdict);
    return verdict;
}

/// Verdict on two rows of 20 strips, `width` mm wide, which bend by an angle at the line between
/// the rows and are `gap` mm apart there. The rows' strips take turns in the model, or not.
Verdict verdict_of_strips(double width, double degrees, double gap, double shift, bool in_turn) {
    test::ModelBuilder builder;
    const double angle = degrees_to_radians(degrees);
    const auto strip = [&](int row, int i) {
        const double at = i * width;
        row == 0 ? builder.plane({-100, at, 0}, {100, 0, 0}, {0, width, 0})
                 : builder.plane({gap, at + shift * width, 0},
                                 {100 * std::cos(angle), 0, 100 * std::sin(angle)}, {0, width, 0});
    };
    for (int i = 0; i < 40; ++i) in_turn ? strip(i % 2, i / 2) : strip(i / 20, i % 20);
    return verdict_of_seams(builder.build(), reach);
}

TEST(Scraps, AreJudgedAlongALineOfNarrowFaces) {
    for (const double width : {0.05, 0.09})
        for (const double shift : {0.0, 0.5})
            for (const bool in_turn : {true, false}) {
                EXPECT_EQ(verdict_of_strips(width, 0, 0, shift, in_turn), Verdict::pass);
                EXPECT_EQ(verdict_of_strips(width, 3, 0, shift, in_turn), Verdict::fail);
                EXPECT_EQ(verdict_of_strips(width, 0, 0.2, shift, in_turn), Verdict::fail);
            }
}

/// Verdict on two faces of 2 x 2 mm, one with a border that overshoots by `spur` mm and folds back;
/// and a face of a metre far away, or not.
Verdict verdict_of_tiny(double spur, bool beside_large) {
    test::ModelBuilder builder;
    builder.plane({0, 0, 0}, {2, 0, 0}, {0, 2, 0});
    builder.polygon({{0, 0}, {1, 0}, {1 - spur / 2, 0}, {1 - spur / 2, 1}, {0, 1}});
    builder.plane({0, 0, 0}, {2, 0, 0}, {0, -2, 0});
    if (beside_large) builder.plane({0, 0, 500}, {1000, 0, 0}, {0, 1000, 0});
    return verdict_of_seams(builder.build(), 0.01);
}

TEST(Scraps, AreTheSameWhateverElseIsInTheModel) {
    for (const bool beside_large : {false, true}) {
        EXPECT_EQ(verdict_of_tiny(0.02, beside_large), Verdict::pass);
        EXPECT_EQ(verdict_of_tiny(0.06, beside_large), Verdict::fail);
    }
}

} // namespace
} // namespace keiko
