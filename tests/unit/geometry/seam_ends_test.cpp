// Where seams begin and end along borders that run apart or past each other.
#include "keiko/geometry/seam/seam.h"
#include "keiko/math/interval_set.h"

#include "tests/support/model_builder.h"
#include "tests/unit/geometry/seam_sides.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace keiko {
namespace {

using namespace test;

TEST(PairSeams, FindsTheExactEndsOfAPartialOverlap) {
    ModelBuilder builder;
    builder.plane({0, 0.02, 0}, along_x, up_y);
    builder.plane({-40, 0, 0}, along_x, down_y);
    const SurfaceModel model = builder.build();
    const auto seams = pair_seams(model, join);
    ASSERT_EQ(seams.size(), 1u);
    EXPECT_EQ(seams[0].a.begin, 0);
    EXPECT_NEAR(seams[0].a.end, 0.6, 1e-12);
    EXPECT_NEAR(seams[0].b.begin, 0.4, 1e-12);
    EXPECT_EQ(seams[0].b.end, 1);
}

TEST(PairSeams, EndsAWedgeWhereItOpensPastTheJoinDistance) {
    const double angle = 0.01;
    ModelBuilder builder;
    builder.plane({0, 0, 0}, along_x, up_y);
    builder.plane({0, 0, 0}, {100 * std::cos(angle), -100 * std::sin(angle), 0}, down_y);
    const auto seams = pair_seams(builder.build(), join);
    ASSERT_EQ(seams.size(), 1u);
    EXPECT_NEAR(seams[0].a.end, join / std::sin(angle) / 100, 1e-9);
}

/// Shares its corners at x = 0 and x = 100 with a border along x and bows away by `bow` mm between.
std::vector<Vec3> bowed_sheet(double bow) {
    return {{0, 0, 0}, {50, -2 * bow, 0}, {100, 0, 0}, {0, -50, 0}, {50, -50, 0}, {100, -50, 0}};
}

TEST(PairSeams, FindsTheClosedEndOfASeamThatGapesOpen) {
    for (const double opening : {2.2, 5.0, 10.0}) {
        const Vec3 away(100, 0, opening);
        const double length = join / std::sin(std::atan(opening / 100));
        for (const bool backwards : {false, true}) {
            ModelBuilder builder;
            builder.plane({0, 0, 0}, along_x, up_y);
            backwards ? builder.plane(away, -away, down_y) : builder.plane({0, 0, 0}, away, down_y);
            const SurfaceModel model = builder.build();
            const auto seams = pair_seams(model, join);
            ASSERT_EQ(seams.size(), 1u) << opening << backwards;
            EXPECT_EQ(seams[0].a.begin, 0);
            EXPECT_NEAR(length_of(model, seams[0].b), length, length * 0.01);
            EXPECT_EQ(seams[0].b.begin, backwards ? 1 : 0);
        }
    }
}

TEST(PairSeams, FindsBothClosedEndsOfABowedBorder) {
    for (const double bow : {0.6, 1.0, 3.0}) {
        ModelBuilder builder;
        builder.plane({0, 0, 0}, along_x, up_y);
        builder.patch(1, 2, bowed_sheet(bow));
        const SurfaceModel model = builder.build();
        const auto seams = pair_seams(model, join);
        ASSERT_EQ(seams.size(), 2u) << bow;
        const double end = (1 - std::sqrt(1 - join / bow)) / 2; // 4 bow x (1 - x) = join
        EXPECT_EQ(seams[0].a.begin, 0);
        EXPECT_NEAR(seams[0].a.end, end, 0.01 * end);
        EXPECT_NEAR((end_of(model, seams[0].a) - end_of(model, seams[0].b)).length(), join, 1e-9);
        EXPECT_NEAR(seams[1].a.begin, 1 - end, 0.01 * end);
        EXPECT_EQ(seams[1].a.end, 1);
    }
}

TEST(PairSeams, PartsBordersWhereThePartnerBowsAwayBetweenLooks) {
    // The bowed border comes first, so that it is the straight one that is sampled.
    ModelBuilder builder;
    builder.patch(1, 2, bowed_sheet(1));
    builder.plane({0, 0, 0}, along_x, up_y);
    EXPECT_EQ(pair_seams(builder.build(), join).size(), 2u);
}

TEST(PairSeams, FindsBordersThatComeNearBetweenTheirEnds) {
    // They cross in a place where no polyline has a corner.
    const double slope = 0.06, cross = 36;
    ModelBuilder builder;
    builder.plane({0, 0, 0}, along_x, up_y);
    builder.plane({0, 0, -cross * slope}, {100, 0, 100 * slope}, down_y);
    const SurfaceModel model = builder.build();
    const auto seams = pair_seams(model, join);
    ASSERT_EQ(seams.size(), 1u);
    EXPECT_NEAR(begin_of(model, seams[0].a).x, cross - join / slope, 0.05);
    EXPECT_NEAR(end_of(model, seams[0].a).x, cross + join / slope, 0.05);
}

/// Covers x in [0, 10] and y from 0 to 5; its border at y = 0 is cut into equal pieces.
std::vector<Vec2> cut_rectangle(int pieces) {
    std::vector<Vec2> corners;
    for (int i = 0; i <= pieces; ++i) corners.emplace_back(static_cast<double>(i) / pieces, 0);
    corners.emplace_back(1, 1);
    corners.emplace_back(0, 1);
    return corners;
}

TEST(PairSeams, DoNotDependOnHowBordersAreCut) {
    // 4 times the gap is more than a piece is long, and pieces end in the middle of others.
    const double gap = 0.05;
    for (const auto& [upper, lower] : {std::pair(1, 200), std::pair(200, 3), std::pair(130, 170)}) {
        ModelBuilder builder;
        builder.plane({0, gap, 0}, {10, 0, 0}, {0, 5, 0});
        builder.polygon(cut_rectangle(upper));
        builder.plane({0, 0, 0}, {10, 0, 0}, {0, -5, 0});
        builder.polygon(cut_rectangle(lower));
        const SurfaceModel model = builder.build();
        double length = 0;
        for (const Seam& seam : pair_seams(model, join)) length += length_of(model, seam.a);
        EXPECT_NEAR(length, 10, 1e-9) << upper << " and " << lower;
    }
}

TEST(PairSeams, GoAlongAGapOfFacesThatAreShorterThanItIsWide) {
    const double gap = 0.49;
    for (const double width : {0.2, 0.5, 1.2, 1.6}) {
        ModelBuilder builder;
        builder.plane({0, 0, 0}, {8 * width, 0, 0}, down_y);
        for (int i = 0; i < 8; ++i) builder.plane({i * width, gap, 0}, {width, 0, 0}, up_y);
        const SurfaceModel model = builder.build();
        double length = 0;
        for (const Seam& seam : pair_seams(model, join))
            if (seam.a.face == 0) length += length_of(model, seam.a);
        // Four times the gap and more, or none.
        EXPECT_NEAR(length, 8 * width > 4 * gap ? 8 * width : 0, 1e-9) << width;
    }
}

TEST(PairSeams, LeaveAScrapAtOneEndOfASeam) {
    // Beyond x = 10 the lower border turns away by 9 degrees; the upper one ends 0.3 mm later.
    ModelBuilder builder;
    builder.plane({0, 0, 0}, {10.3, 0, 0}, {0, 5, 0});
    const double away = 10 * std::tan(9 * std::numbers::pi / 180);
    builder.plane({0, -10, 0}, {20, 0, 0}, {0, 10, 0});
    builder.polygon({{0, 0}, {1, 0}, {1, 1 - away / 10}, {0.5, 1}, {0, 1}});
    const SurfaceModel model = builder.build();
    const auto seams = pair_seams(model, join);
    ASSERT_EQ(seams.size(), 1u);
    EXPECT_NEAR(length_of(model, seams[0].a), 10, 1e-9);
}

/// A sheet from a border that goes along `along`, with triangular notches of that depth.
void toothed_sheet(ModelBuilder& builder, double high, double period, const Vec3& along,
                   const Vec3& inward, const Vec3& from = Vec3(0)) {
    builder.plane(from - inward, along, inward * 2);
    const double length = along.length(), unit = 2 * inward.length();
    std::vector<Vec2> corners{{0, 1}, {0, 0.5}};
    for (double x = period; x <= length - period; x += period) {
        corners.emplace_back((x - period / 2) / length, 0.5 + high / unit);
        corners.emplace_back(x / length, 0.5);
    }
    corners.insert(corners.end(), {{1, 0.5}, {1, 1}});
    builder.polygon(corners);
}

const Vec3 along_5(5, 0, 0), up_5(0, 5, 0), down_5(0, -5, 0);

/// Share of the first border of a face without loops that belongs to seams.
double paired_share(const SurfaceModel& model, std::uint32_t face) {
    std::vector<ParameterInterval> parts;
    for (const Seam& seam : pair_seams(model, join))
        for (const BoundaryInterval& on : {seam.a, seam.b})
            if (on.face == face && on.curve == natural_side)
                parts.push_back({std::min(on.begin, on.end), std::max(on.begin, on.end)});
    return IntervalSet(std::move(parts)).measure();
}

TEST(PairSeams, GoAlongTeethOfAnyHeightWithinTheJoinDistance) {
    for (const double high : {0.004, 0.03, 0.2, 0.45})
        for (const double periods : {1.5, 5.0, 11.0}) {
            const double period = std::max(high, 0.008) * periods;
            for (const bool teeth_first : {false, true}) {
                ModelBuilder builder;
                if (teeth_first) toothed_sheet(builder, high, period, along_5, down_5);
                builder.plane({0, 0, 0}, along_5, up_5);
                if (!teeth_first) toothed_sheet(builder, high, period, along_5, down_5);
                EXPECT_GE(paired_share(builder.build(), teeth_first ? 1 : 0), 1 - 3 * period / 5)
                    << high << " mm, " << period << teeth_first;
            }
        }
}

TEST(PairSeams, GoAlongTeethOfBothBorders) {
    for (const double high : {0.004, 0.1})
        for (const double other_period : {5.0, 3.7}) {
            ModelBuilder builder;
            toothed_sheet(builder, high, 5 * high, along_5, down_5);
            toothed_sheet(builder, high, other_period * high, along_5, up_5);
            double length = 0;
            const SurfaceModel model = builder.build();
            for (const Seam& seam : pair_seams(model, join)) length += length_of(model, seam.a);
            EXPECT_GT(length, 4) << high << " mm, " << other_period;
        }
}

TEST(PairSeams, DoNotJoinBordersWithTeethThatCrossOrLeaveACorner) {
    for (const double degrees : {20.0, 45.0, 90.0}) {
        const double angle = degrees * std::numbers::pi / 180;
        const Vec3 along = Vec3(std::cos(angle), std::sin(angle), 0) * 5;
        for (const Vec3& from : {Vec3(0), Vec3(2.5, 0, 0) - along / 2}) {
            ModelBuilder builder;
            builder.plane({0, 0, 0}, along_5, down_5);
            toothed_sheet(builder, 0.004, 0.02, along, {0, 0, 5}, from);
            EXPECT_TRUE(pair_seams(builder.build(), join).empty()) << degrees << ", " << from.x;
        }
    }
}

TEST(PairSeams, FollowABorderThatStepsAside) {
    for (const double step : {0.01, 0.1, 0.3}) {
        ModelBuilder builder;
        builder.plane({0, 0, 0}, along_5, up_5);
        builder.plane({0, -5, 0}, along_5, up_5);
        const double low = 1 - step / 5;
        builder.polygon({{0, 0}, {1, 0}, {1, low}, {0.4, low}, {0.4, 1}, {0, 1}});
        EXPECT_NEAR(paired_share(builder.build(), 0), 1, 1e-9) << step;
    }
}

} // namespace
} // namespace keiko
