#include "keiko/triage/triage.h"

#include "tests/unit/triage/triaged_sheets.h"
#include <gtest/gtest.h>

#include <vector>

namespace keiko {
namespace {

using test::ModelBuilder;
using test::Triaged;

constexpr double side = 300;

/// A square sheet and four others, each bent down from one of its sides by an angle in degrees: at
/// the right, at the rear, at the left and in front.
void cross(ModelBuilder& builder, const Vec3& from, const std::vector<double>& degrees) {
    const double width = 100;
    const Vec3 x(side, 0, 0), y(0, side, 0);
    builder.plane(from, x, y);
    const Vec3 origins[] = {x, y, {0, 0, 0}, {0, 0, 0}};
    const Vec3 runs[] = {y, x, y, x};
    const Vec3 out[] = {{width, 0, 0}, {0, width, 0}, {-width, 0, 0}, {0, -width, 0}};
    for (std::size_t i = 0; i < degrees.size(); ++i) {
        const double turn = degrees_to_radians(degrees[i]);
        builder.plane(from + origins[i], runs[i],
                      out[i] * std::cos(turn) - Vec3(0, 0, width * std::sin(turn)));
    }
}

TEST(BadPatches, AFaceWhoseSeamsMostlyFailIsOneFault) {
    ModelBuilder builder;
    cross(builder, {0, 0, 0}, {0.5, 0.3, 0.4, 0});
    const Triaged found(builder);
    ASSERT_EQ(found.inspection.findings.size(), 3u);
    ASSERT_EQ(found.triage.items.size(), 1u);
    const TriageItem& item = found.triage.items[0];
    EXPECT_EQ(item.patch, 0u);
    EXPECT_EQ(item.seams.size(), 3u);
    EXPECT_NEAR(item.length, 3 * side, 1e-6);
    EXPECT_NEAR(found.angle_of(item), 0.5, 1e-6) << "the worst leads";
}

TEST(BadPatches, AFaceOfWhoseSeamsHalfPassIsNone) {
    ModelBuilder builder;
    cross(builder, {0, 0, 0}, {0.5, 0.3, 0, 0});
    const Triaged found(builder);
    ASSERT_EQ(found.triage.items.size(), 2u);
    for (const TriageItem& item : found.triage.items) EXPECT_EQ(item.patch, no_index);
}

TEST(BadPatches, ASingleFaultIsOfItsSeamNotOfAPatch) {
    ModelBuilder builder;
    cross(builder, {0, 0, 0}, {0.5});
    const Triaged found(builder);
    ASSERT_EQ(found.triage.items.size(), 1u);
    EXPECT_EQ(found.triage.items[0].patch, no_index);
}

/// A line that goes on beyond the face is no fault of that face alone.
TEST(BadPatches, AFaultThatReachesBeyondTheFaceIsItsOwn) {
    for (const bool beyond : {false, true}) {
        ModelBuilder builder;
        cross(builder, {0, 0, 0}, {0.5});
        const double turn = degrees_to_radians(0.5);
        builder.plane({0, 0, 0}, {side, 0, 0}, {0, -100 * std::cos(turn), -100 * std::sin(turn)});
        if (beyond) test::bent_pair(builder, {-1 - side, 0, 0}, side, 0.5);
        const Triaged found(builder);
        ASSERT_EQ(found.triage.items.size(), beyond ? 2u : 1u);
        for (const TriageItem& item : found.triage.items) EXPECT_EQ(item.patch == no_index, beyond);
    }
}

TEST(BadPatches, ImagesOfEachOtherAreOneFaultToo) {
    ModelBuilder builder;
    cross(builder, {0, 400, 0}, {0.5, 0.3, 0.4, 0});
    cross(builder, {0, -400 - side, 0}, {0.5, 0, 0.4, 0.3});
    const Triaged found(builder);
    ASSERT_EQ(found.triage.items.size(), 1u);
    EXPECT_TRUE(found.triage.items[0].mirrored);
    EXPECT_NE(found.triage.items[0].patch, no_index);
    EXPECT_EQ(found.triage.items[0].seams.size(), 6u);
}

/// Gaps are closed by other means.
TEST(BadPatches, AGapIsNoPartOfThem) {
    ModelBuilder builder;
    cross(builder, {0, 0, 0}, {0.5, 0.3});
    builder.plane({0, -0.05, 0}, {side, 0, 0}, {0, -100, 0});
    const Triaged found(builder);
    ASSERT_EQ(found.triage.items.size(), 2u);
    for (const TriageItem& item : found.triage.items)
        EXPECT_EQ(item.patch == no_index, item.mending == Mending::position);
}

} // namespace
} // namespace keiko
