#include "keiko/inspect/seams/seam_line.h"

#include "tests/support/model_builder.h"
#include <gtest/gtest.h>

#include <algorithm>

namespace keiko {
namespace {

MeasuredSeam scrap(std::uint32_t face_a, std::uint32_t face_b, double length, Verdict verdict) {
    MeasuredSeam seam;
    seam.face_a = face_a, seam.face_b = face_b;
    seam.length = length, seam.verdict = verdict, seam.severity = 3, seam.scrap = true;
    seam.negligible = 0.1;
    return seam;
}

TEST(ExcuseScraps, TakesScrapsOutOfTheVerdict) {
    std::vector<MeasuredSeam> seams{scrap(0, 1, 0.05, Verdict::fail),
                                    scrap(0, 2, 0.04, Verdict::undecided)};
    excuse_scraps(seams);
    for (const MeasuredSeam& seam : seams) {
        EXPECT_TRUE(seam.scrap);
        EXPECT_EQ(seam.verdict, Verdict::pass);
        EXPECT_EQ(seam.severity, 0);
    }
}

TEST(ExcuseScraps, JudgesThoseOfAFaceThatAreTogetherMoreThanNegligible) {
    // Face 0 has 0.11 mm that do not pass, face 3 has 0.06.
    std::vector<MeasuredSeam> seams{
        scrap(0, 1, 0.06, Verdict::fail), scrap(2, 0, 0.05, Verdict::undecided),
        scrap(0, 4, 0.09, Verdict::pass), scrap(3, 5, 0.06, Verdict::fail)};
    excuse_scraps(seams);
    EXPECT_FALSE(seams[0].scrap);
    EXPECT_EQ(seams[0].verdict, Verdict::fail);
    EXPECT_EQ(seams[0].severity, 3);
    EXPECT_FALSE(seams[1].scrap);
    EXPECT_EQ(seams[1].verdict, Verdict::undecided);
    EXPECT_TRUE(seams[2].scrap); // what passes needs no excuse
    EXPECT_TRUE(seams[3].scrap);
    EXPECT_EQ(seams[3].verdict, Verdict::pass);
}

TEST(ExcuseScraps, CountsTheScrapsOfEachPlacedFaceAlone) {
    std::vector<MeasuredSeam> seams{scrap(0, 1, 0.06, Verdict::fail),
                                    scrap(0, 1, 0.06, Verdict::fail)};
    seams[1].instance_a = seams[1].instance_b = 1;
    excuse_scraps(seams);
    for (const MeasuredSeam& seam : seams) EXPECT_TRUE(seam.scrap);
    std::vector<MeasuredSeam> closed{scrap(0, 0, 0.06, Verdict::fail)}; // one face, counted once
    excuse_scraps(closed);
    EXPECT_TRUE(closed[0].scrap);
}

TEST(ExcuseScraps, LeavesStretchesAsTheyAre) {
    std::vector<MeasuredSeam> seams{scrap(0, 1, 5, Verdict::fail)};
    seams[0].scrap = false;
    excuse_scraps(seams);
    EXPECT_EQ(seams[0].verdict, Verdict::fail);
}

/// Verdict on two faces of 2 x 2 mm, one with a border that overshoots by `spur` mm and folds back;
/// and a face of a metre far away, or not.
Verdict verdict_of_tiny(double spur, bool beside_large) {
    test::ModelBuilder builder;
    builder.plane({0, 0, 0}, {2, 0, 0}, {0, 2, 0});
    builder.polygon({{0, 0}, {1, 0}, {1 - spur / 2, 0}, {1 - spur / 2, 1}, {0, 1}});
    builder.plane({0, 0, 0}, {2, 0, 0}, {0, -2, 0});
    if (beside_large) builder.plane({0, 0, 500}, {1000, 0, 0}, {0, 1000, 0});
    const SurfaceModel model = builder.build();
    Verdict verdict = Verdict::pass;
    constexpr double join = 0.01; // mm
    for (const MeasuredSeam& seam : measure_seams(model, pair_seams(model, join), {}, join).seams)
        verdict = std::max(verdict, seam.verdict);
    return verdict;
}

TEST(Scraps, AreTheSameWhateverElseIsInTheModel) {
    for (const bool beside_large : {false, true}) {
        EXPECT_EQ(verdict_of_tiny(0.02, beside_large), Verdict::pass);
        EXPECT_EQ(verdict_of_tiny(0.06, beside_large), Verdict::fail);
    }
}

} // namespace
} // namespace keiko
