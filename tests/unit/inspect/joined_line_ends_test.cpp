#include "keiko/geometry/trim/material_bounds.h"
#include "keiko/import/worker/load_model.h"
#include "keiko/scene/view.h"

#include "tests/support/paths.h"
#include "tests/unit/inspect/lamps_over_sheets.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

using test::folded_sheets;
using test::joined;
using test::lamps_turned;
using test::parallel_camera;

TEST(JoinedLines, OfTheHoodRunOverItsPatchesAndSmoothSeamsUnbroken) {
    const SurfaceModel model = load_model(test::repository("surfaces/hood.step"));
    const Box3 body = material_bounds(model);
    const Camera camera = frame_view("high-front", body);
    CPlane plane = lamps_turned(0, 12);
    plane.origin += body.center();
    const JoinedLines found = joined(model, plane, camera);
    EXPECT_GE(found.pieces.size(), 3 * found.lines.size()); // three spans along each line
    EXPECT_FALSE(found.crossings.empty());
    for (const LineCrossing& crossing : found.crossings) {
        EXPECT_TRUE(crossing.continued()) << crossing.faces << crossing.place;
        EXPECT_EQ(crossing.verdict, Verdict::pass);
        EXPECT_LT(std::abs(crossing.jump.value), 1e-3);
        EXPECT_LT(std::abs(crossing.kink.value), 0.1);
    }
    for (const JoinedLine& line : found.lines) {
        for (std::size_t i = 1; i < line.pieces.size(); ++i) {
            const auto& before = found.pieces[line.pieces[i - 1]].line.points;
            const auto& after = found.pieces[line.pieces[i]].line.points;
            EXPECT_LT((after.front().place - before.back().place).length(), 1e-3);
        }
        EXPECT_NE(line.begin, LineEnd::patch);
        EXPECT_NE(line.end, LineEnd::patch);
        EXPECT_NE(line.begin, LineEnd::seam);
        EXPECT_NE(line.end, LineEnd::seam);
    }
}

TEST(JoinedLines, AreTheSameForOneAndTwoThreads) {
    const SurfaceModel model = load_model(test::repository("surfaces/seam-g1-angle.step"));
    const Camera camera = frame_view("high-front", material_bounds(model));
    const auto one = joined(model, lamps_turned(0.6, 300), camera, {}, {.threads = 1});
    const auto two = joined(model, lamps_turned(0.6, 300), camera, {}, {.threads = 2});
    ASSERT_FALSE(one.crossings.empty());
    ASSERT_EQ(one.crossings.size(), two.crossings.size());
    for (std::size_t i = 0; i < one.crossings.size(); ++i) {
        EXPECT_EQ(one.crossings[i].place, two.crossings[i].place);
        EXPECT_EQ(one.crossings[i].kink.value, two.crossings[i].kink.value);
        EXPECT_EQ(one.crossings[i].to, two.crossings[i].to);
    }
    ASSERT_EQ(one.lines.size(), two.lines.size());
    for (std::size_t i = 0; i < one.lines.size(); ++i)
        EXPECT_EQ(one.lines[i].pieces, two.lines[i].pieces);
}

/// The lower sheet of two begins behind the edge of the upper one, for eye and lamps.
TEST(JoinedLines, GoOnOverAStepFromEitherSide) {
    for (const double step : {-0.02, 0.02})
        for (const Vec3& direction : {Vec3(0.2, 0.8, -0.6), Vec3(0.2, -0.8, -0.6)}) {
            test::ModelBuilder builder;
            test::flat_sheet(builder, {0, -100, 0});
            test::flat_sheet(builder, {0, 100, 0}, {0, 0, step});
            const JoinedLines found = joined(builder.build(), lamps_turned(0.9, 300),
                                             parallel_camera(direction.normalized()));
            EXPECT_GT(found.crossings.size(), 3u);
            for (const LineCrossing& crossing : found.crossings) {
                const Vec3& place = crossing.place;
                if (place.x < 1 || place.x > test::sheet_length - 1) continue;
                EXPECT_TRUE(crossing.continued()) << step << direction << place;
            }
        }
}

/// A sheet whose neighbour across the x axis is two sheets that meet in the middle.
TEST(JoinedLines, GoOnOverATJunction) {
    test::ModelBuilder builder;
    test::flat_sheet(builder, {0, -100, 0});
    const double half = test::sheet_length / 2;
    const Vec3 across = Vec3(0, 100, -0.2);
    builder.plane({0, 0, 0}, {half, 0, 0}, across);
    builder.plane({half, 0, 0}, {half, 0, 0}, across);
    const Vec3 direction = Vec3(0.2, 0.5, -1).normalized();
    const JoinedLines found =
        joined(builder.build(), lamps_turned(0.9), parallel_camera(direction));
    std::size_t continued = 0, faces = 0;
    for (const LineCrossing& crossing : found.crossings) {
        continued += crossing.continued() ? 1 : 0;
        faces |= crossing.continued() ? std::size_t{1} << found.pieces[crossing.to].face : 0;
    }
    EXPECT_GT(continued, 15u);
    // Only at the ends of the seam an image may jump off the sheets.
    EXPECT_LE(found.crossings.size() - continued, 8u);
    EXPECT_NE(faces & 2, 0u);
    EXPECT_NE(faces & 4, 0u);
}

TEST(JoinedLines, EndAtAFreeBorderAndAtACrease) {
    const Vec3 direction = Vec3(0.2, 0.5, -1).normalized();
    const JoinedLines found =
        joined(folded_sheets(8), lamps_turned(0.9), parallel_camera(direction));
    std::size_t crease = 0, free_border = 0, other = 0;
    for (const JoinedLine& line : found.lines)
        for (const LineEnd end : {line.begin, line.end})
            ++(end == LineEnd::crease ? crease : end == LineEnd::free_border ? free_border : other);
    EXPECT_TRUE(found.crossings.empty());
    EXPECT_GT(crease, 3u);
    EXPECT_GT(free_border, 3u);
    EXPECT_EQ(other, 0u);
}

} // namespace
} // namespace keiko
