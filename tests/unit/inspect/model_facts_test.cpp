#include "keiko/inspect/model_facts.h"

#include "tests/unit/inspect/sheets.h"
#include <gtest/gtest.h>

#include <numbers>

namespace keiko {
namespace {

TEST(ModelFacts, CountsFacesPatchesAndDegrees) {
    test::ModelBuilder builder;
    builder.rational_patch(1, 2, test::arc_sheet(0, 80, 0, std::numbers::pi / 2));
    test::flat_sheet(builder, {0, 50, 0});
    builder.polygon({{0, 0}, {1, 0}, {1, 1}});
    SurfaceModel model = builder.build();
    model.unit = "INCH";
    model.faces[0].approximated = 0.003;
    model.lost_faces.push_back({9, "rear", "no surface"});
    const ModelFacts facts = model_facts(model, {}, 0.5);
    EXPECT_EQ(facts.faces, 2u);
    EXPECT_EQ(facts.patches, 2u);
    EXPECT_EQ(facts.trimmed_faces, 1u);
    EXPECT_EQ(facts.rational_patches, 1u);
    EXPECT_EQ(facts.degrees.at({1, 2}), 1u);
    EXPECT_EQ(facts.degrees.at({1, 1}), 1u);
    EXPECT_EQ(facts.kinds.at("b-spline"), 2u);
    EXPECT_EQ(facts.approximated_faces, 1u);
    EXPECT_EQ(facts.largest_approximation, 0.003);
    EXPECT_EQ(facts.unit, "INCH");
    ASSERT_EQ(facts.lost_faces.size(), 1u);
    EXPECT_EQ(facts.lost_faces[0].reason, "no surface");
    EXPECT_EQ(facts.bounds.upper.x, test::sheet_length);
}

TEST(ModelFacts, SumsTheBordersThatMeetNothing) {
    test::ModelBuilder builder;
    test::flat_sheet(builder, {0, 50, 0});
    test::flat_sheet(builder, {0, -30, 0}, {40, 0, 0});
    const SurfaceModel model = builder.build();
    const ModelFacts facts = model_facts(model, pair_seams(model, 0.5), 0.5);
    EXPECT_NEAR(facts.border_length, 2 * (100 + 50) + 2 * (100 + 30), 1e-9);
    EXPECT_NEAR(facts.free_length, facts.border_length - 2 * 60, 1e-9);
}

TEST(ModelFacts, CountsPlacedFacesOncePerInstance) {
    test::ModelBuilder builder;
    test::flat_sheet(builder, {0, 50, 0});
    builder.instance({});
    builder.instance(Affine::translate({0, 0, 100}));
    const ModelFacts facts = model_facts(builder.build(), {}, 0.5);
    EXPECT_EQ(facts.faces, 1u);
    EXPECT_EQ(facts.placed_faces, 2u);
    EXPECT_NEAR(facts.free_length, 2 * 300, 1e-9);
    EXPECT_EQ(facts.bounds.upper.z, 100);
}

TEST(ModelFacts, ListsPartsFacesEdgesAndRemarks) {
    test::ModelBuilder builder;
    builder.rational_patch(1, 2, test::arc_sheet(0, 80, 0, std::numbers::pi / 2));
    test::flat_sheet(builder, {0, 50, 0});
    builder.instance({});
    Affine mirror;
    mirror.rows[1] = Vec3(0, -1, 0);
    builder.instance(mirror);
    SurfaceModel model = builder.build();
    model.unit = "in";
    model.faces[1].name = "sill", model.faces[1].color = Rgb(1, 0, 0);
    model.edges = {{.tolerance = 1e-3}, {.tolerance = 2e-3, .degenerate = true}};
    model.repairs = {{1, RepairKind::gap_bridged, 2, 0.5, ""},
                     {2, RepairKind::gap_bridged, 1, 0.25, ""}};
    model.diagnostics = {{Severity::note, "", "a"}, {Severity::note, "", "b"}};
    const ModelFacts facts = model_facts(model, {}, 0.25);
    ASSERT_EQ(facts.part_list.size(), 1u);
    EXPECT_EQ(facts.part_list[0].faces, 2u);
    EXPECT_EQ(facts.part_list[0].patches, 2u);
    EXPECT_EQ(facts.part_list[0].instances, 2u);
    EXPECT_EQ(facts.part_list[0].mirrored_instances, 1u);
    ASSERT_EQ(facts.face_list.size(), 2u);
    EXPECT_EQ(facts.face_list[0].degree, (std::array{1, 2}));
    EXPECT_TRUE(facts.face_list[0].rational);
    EXPECT_EQ(facts.face_list[1].name, "sill");
    EXPECT_EQ(facts.face_list[1].color, Rgb(1, 0, 0));
    EXPECT_EQ(facts.edges, 2u);
    EXPECT_EQ(facts.degenerate_edges, 1u);
    EXPECT_EQ(facts.largest_edge_tolerance, 2e-3);
    EXPECT_EQ(facts.remarks.notes, 2u);
    EXPECT_EQ(facts.remarks.errors, 0u);
    const RepairTotal& gaps = facts.repair_totals.at(RepairKind::gap_bridged);
    EXPECT_EQ(gaps.count, 3u);
    EXPECT_EQ(gaps.faces, 2u);
    EXPECT_EQ(gaps.size, 0.5);
    EXPECT_EQ(facts.millimetres_per_unit, 25.4);
    EXPECT_EQ(facts.join, 0.25);
}

} // namespace
} // namespace keiko
