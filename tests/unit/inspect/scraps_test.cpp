#include "keiko/inspect/seam_line.h"

#include <gtest/gtest.h>

namespace keiko {
namespace {

constexpr double negligible = 0.1; ///< mm

MeasuredSeam scrap(std::uint32_t face_a, std::uint32_t face_b, double length, Verdict verdict) {
    MeasuredSeam seam;
    seam.face_a = face_a, seam.face_b = face_b;
    seam.length = length, seam.verdict = verdict, seam.severity = 3, seam.scrap = true;
    return seam;
}

TEST(ExcuseScraps, TakesScrapsOutOfTheVerdict) {
    std::vector<MeasuredSeam> seams{scrap(0, 1, 0.05, Verdict::fail),
                                    scrap(0, 2, 0.04, Verdict::undecided)};
    excuse_scraps(seams, negligible);
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
    excuse_scraps(seams, negligible);
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
    excuse_scraps(seams, negligible);
    for (const MeasuredSeam& seam : seams) EXPECT_TRUE(seam.scrap);
    std::vector<MeasuredSeam> closed{scrap(0, 0, 0.06, Verdict::fail)}; // one face, counted once
    excuse_scraps(closed, negligible);
    EXPECT_TRUE(closed[0].scrap);
}

TEST(ExcuseScraps, LeavesStretchesAsTheyAre) {
    std::vector<MeasuredSeam> seams{scrap(0, 1, 5, Verdict::fail)};
    seams[0].scrap = false;
    excuse_scraps(seams, negligible);
    EXPECT_EQ(seams[0].verdict, Verdict::fail);
}

} // namespace
} // namespace keiko
