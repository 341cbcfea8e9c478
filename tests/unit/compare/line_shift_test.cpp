#include "keiko/compare/line_shift.h"

#include <gtest/gtest.h>

namespace keiko {
namespace {

/// A straight line of one lamp along x, from `from` to `to`, at height y.
void add_line(JoinedLines& lines, std::uint32_t lamp, double y, double from = 0, double to = 100) {
    SurfaceLine piece;
    piece.lamp = lamp;
    for (int i = 0; i <= 10; ++i)
        piece.line.points.push_back({Vec2(0), Vec3(from + (to - from) * i / 10, y, 0)});
    JoinedLine line;
    line.lamp = lamp, line.length = to - from;
    line.pieces = {static_cast<std::uint32_t>(lines.pieces.size())};
    lines.pieces.push_back(piece);
    lines.lines.push_back(line);
}

JoinedLines one(std::uint32_t lamp, double y, double from = 0, double to = 100) {
    JoinedLines lines;
    add_line(lines, lamp, y, from, to);
    return lines;
}

TEST(LineShift, IsNoneOfALineToItself) {
    const LineShift shift = line_shifts(one(0, 3), one(0, 3))[0];
    EXPECT_NEAR(shift.length, 100, 1e-9);
    EXPECT_EQ(shift.largest, 0);
    EXPECT_EQ(shift.alone, 0);
}

TEST(LineShift, IsTheDistanceOfAParallelLine) {
    const LineShift shift = line_shifts(one(2, 3), one(2, 4.25))[0];
    EXPECT_NEAR(shift.mean, 1.25, 1e-12);
    EXPECT_NEAR(shift.largest, 1.25, 1e-12);
    EXPECT_EQ(shift.lamp, 2u);
}

TEST(LineShift, LooksAtTheSameLampOnly) {
    const LineShift shift = line_shifts(one(0, 3), one(1, 3))[0];
    EXPECT_NEAR(shift.alone, 100, 1e-9);
    EXPECT_EQ(shift.largest, 0);
}

TEST(LineShift, TellsHowMuchOfALineHasGoneApartFromHowFarItMoved) {
    const LineShift shift = line_shifts(one(0, 0), one(0, 0.5, 0, 60))[0];
    EXPECT_NEAR(shift.alone, 40, 2.5); // but for what is beside the end rather than ahead of it
    EXPECT_NEAR(shift.largest, 0.5, 0.25);
    EXPECT_NEAR(shift.mean, 0.5, 0.02);
}

TEST(LineShift, TakesTheNearestOfSeveralLinesOfALamp) {
    JoinedLines lines = one(0, 10);
    add_line(lines, 0, 0.25);
    EXPECT_NEAR(line_shifts(one(0, 0), lines)[0].largest, 0.25, 1e-12);
}

TEST(LineShift, DoesNotPairLinesThatAreFarApart) {
    EXPECT_NEAR(line_shifts(one(0, 0), one(0, 80))[0].alone, 100, 1e-9);
}

} // namespace
} // namespace keiko
