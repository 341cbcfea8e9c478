#include "keiko/inspect/inspection.h"

#include "keiko/base/units.h"
#include "keiko/files/scene/preset_file.h"

#include "tests/unit/inspect/sheets.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

using test::ModelBuilder;

/// Strips beside each other across y, each tilted by its number of `degrees` against the one
/// before.
SurfaceModel strips(const std::vector<double>& degrees, double gap = 0) {
    ModelBuilder builder;
    Vec3 from(0);
    double tilt = 0;
    for (std::size_t i = 0; i <= degrees.size(); ++i) {
        const Vec3 across(0, 20 * std::cos(tilt), -20 * std::sin(tilt));
        test::flat_sheet(builder, across, from);
        from += across + Vec3(0, gap, 0);
        if (i < degrees.size()) tilt += degrees_to_radians(degrees[i]);
    }
    return builder.build();
}

TEST(Inspect, CountsSeamsByVerdict) {
    const Inspection result = inspect(strips({0.05, 0.3, 0, 30, 0.2}));
    EXPECT_EQ(result.counts, (SeamCounts{.fail = 2, .undecided = 0, .pass = 2, .creases = 1}));
    EXPECT_EQ(result.verdict, Verdict::fail);
    EXPECT_EQ(result.seams.size(), 5u);
    EXPECT_EQ(result.facts.seams, 5u);
}

TEST(Inspect, DoesNotPassAModelThatLostFaces) {
    SurfaceModel model = strips({0, 0});
    model.lost_faces.push_back({9, "rear", "no surface"});
    EXPECT_EQ(inspect(model).verdict, Verdict::undecided);
}

TEST(Inspect, PassesASmoothModelWithoutFindings) {
    const Inspection result = inspect(strips({0, 0.09, 45}));
    EXPECT_EQ(result.verdict, Verdict::pass);
    EXPECT_TRUE(result.findings.empty());
}

TEST(Inspect, SaysWhereASideHasNoNormal) {
    ModelBuilder builder;
    test::flat_sheet(builder, {0, 50, 0});
    // The rows of control points by the seam coincide over the second half.
    NurbsSurface half{1, 2, {0, 0, 1, 2, 2}, {0, 0, 0, 1, 1, 1}, {}};
    for (int i = 0; i < 3; ++i)
        for (const double y : {0.0, i == 0 ? -25.0 : 0.0, -50.0})
            half.points.emplace_back(test::sheet_length * i / 2, y, 0, 1);
    builder.nurbs(half);
    const Inspection result = inspect(builder.build());
    EXPECT_EQ(result.verdict, Verdict::undecided);
    ASSERT_EQ(result.findings.size(), 1u);
    EXPECT_NE(result.findings[0].message.find("a side has no normal"), std::string::npos)
        << result.findings[0].message;
}

TEST(Inspect, ListsFindingsWorstFirst) {
    const Inspection result = inspect(strips({0.2, 0.4, 0.3}));
    ASSERT_EQ(result.findings.size(), 3u);
    EXPECT_NEAR(result.findings[0].worst.value, 0.4, 1e-9);
    EXPECT_NEAR(result.findings[1].worst.value, 0.3, 1e-9);
    EXPECT_NEAR(result.findings[2].worst.value, 0.2, 1e-9);
    EXPECT_EQ(result.findings[0].code, "G-SU-NT");
    EXPECT_EQ(result.findings[0].rule, "g1_discontinuity_between_adjacent_faces");
    EXPECT_EQ(result.findings[0].unit, "deg");
    EXPECT_EQ(result.findings[0].faces, "face 2 | face 3");
    EXPECT_EQ(result.findings[0].message,
              "the angle of 0.4 degrees is over the limit of 0.1 degrees");
    EXPECT_EQ(result.seams[result.findings[0].seam].face_b, 2u);
}

TEST(Inspect, NamesTheSkinsOfASheetAsTheCauseOfAFold) {
    for (const double thick : {0.0, 0.3}) {
        ModelBuilder builder;
        test::flat_sheet(builder, {0, 50, 0});
        test::flat_sheet(builder, {0, 50, 0}, {0, 0, thick});
        const Inspection result = inspect(builder.build());
        EXPECT_EQ(result.verdict, Verdict::fail);
        ASSERT_FALSE(result.findings.empty());
        const std::string& message = result.findings[0].message;
        EXPECT_EQ(message.find("two skins of a thin sheet") != std::string::npos, thick > 0)
            << message;
    }
}

TEST(Inspect, ReportsGapsUnderTheirCode) {
    const Inspection result = inspect(strips({0}, 0.04));
    ASSERT_EQ(result.findings.size(), 1u);
    EXPECT_EQ(result.findings[0].code, "G-SU-LG");
    EXPECT_NEAR(result.findings[0].worst.value, 0.04, 1e-12);
    EXPECT_EQ(inspect(strips({0}, 0.04), preset_by_name("engineering")).verdict, Verdict::pass);
}

TEST(Inspect, MarksSeamsThatAreWorstAtAnIrregularPoint) {
    SurfaceModel model = strips({0}, 0.04);
    EXPECT_FALSE(inspect(model).seams[0].irregular);
    const Vec3 worst = inspect(model).seams[0].gap.place;
    model.irregular_patches = {{0, worst + Vec3(0, 0, 3), 1}, {1, worst + Vec3(0, 1, 0), 2}};
    EXPECT_TRUE(inspect(model).seams[0].irregular);
    model.irregular_patches.pop_back();
    EXPECT_FALSE(inspect(model).seams[0].irregular);
}

TEST(Inspect, NamesTheInstancesWhereThereAreSeveral) {
    ModelBuilder builder;
    test::flat_sheet(builder, {0, 50, 0});
    builder.instance({});
    builder.instance(Affine::translate({0, -50.03, 0}));
    const Inspection result = inspect(builder.build());
    ASSERT_EQ(result.findings.size(), 1u);
    EXPECT_EQ(result.findings[0].faces, "face 1 of instance 1 | face 1 of instance 2");
}

TEST(Inspect, OrdersTheWorstSeamsAndLeavesCreasesOut) {
    const Inspection result = inspect(strips({0.05, 0.3, 0, 30, 0.2}));
    const auto order = worst_seams(result, 3);
    ASSERT_EQ(order.size(), 3u);
    EXPECT_NEAR(result.seams[order[0]].angle->value, 0.3, 1e-9);
    EXPECT_NEAR(result.seams[order[1]].angle->value, 0.2, 1e-9);
    EXPECT_NEAR(result.seams[order[2]].angle->value, 0.05, 1e-9);
    EXPECT_EQ(worst_seams(result, 100).size(), 4u);
}

TEST(WorstPlace, IsThatOfTheQuantityFurthestOverItsLimit) {
    MeasuredSeam seam;
    seam.gap = {
        .value = 0.02, .bound = 0, .limit = 0.01, .place = Vec3(1, 0, 0), .verdict = Verdict::fail};
    seam.angle = MeasuredValue{
        .value = 0.3, .bound = 0, .limit = 0.1, .place = Vec3(2, 0, 0), .verdict = Verdict::fail};
    EXPECT_EQ(worst_place(seam), Vec3(2, 0, 0));
    seam.gap.value = 0.04;
    EXPECT_EQ(worst_place(seam), Vec3(1, 0, 0));
    seam.angle->value = 30, seam.kind = SeamClass::crease;
    EXPECT_EQ(worst_place(seam), Vec3(1, 0, 0));
}

TEST(Inspect, IsTheSameForAnyNumberOfThreads) {
    const SurfaceModel model = strips(std::vector<double>(30, 0.123), 0.0077);
    Job one, four;
    one.threads = 1, four.threads = 4;
    const Inspection a = inspect(model, {}, 0.5, one), b = inspect(model, {}, 0.5, four);
    ASSERT_EQ(a.seams.size(), b.seams.size());
    for (std::size_t i = 0; i < a.seams.size(); ++i) {
        EXPECT_EQ(a.seams[i].gap.value, b.seams[i].gap.value);
        EXPECT_EQ(a.seams[i].angle->value, b.seams[i].angle->value);
        EXPECT_EQ(a.seams[i].length, b.seams[i].length);
    }
}

TEST(Inspection, AFaceThatIsThereTwiceIsNoCrease) {
    test::ModelBuilder builder;
    for (int i = 0; i < 2; ++i) builder.plane({0, 0, 0}, {100, 0, 0}, {0, 50, 0});
    const Inspection doubled = inspect(builder.build());
    EXPECT_EQ(doubled.verdict, Verdict::fail);
    EXPECT_EQ(doubled.counts.creases, 0u);
}

} // namespace
} // namespace keiko
