#include "keiko/inspect/acceptance.h"

#include "keiko/inspect/inspection.h"

#include "tests/unit/inspect/sheets.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

using Kind = AcceptanceRemark::Kind;

const AcceptanceNote note{"Ann", "hidden by the trim", "2026-11-27", "2027-01-31"};

/// Sheets 20 mm wide, with these gaps between them, mm.
SurfaceModel sheets(const std::vector<double>& gaps, const Vec3& shift = Vec3(0)) {
    test::ModelBuilder builder;
    Vec3 from = shift;
    for (std::size_t i = 0; i <= gaps.size(); ++i) {
        test::flat_sheet(builder, {0, 20, 0}, from);
        from += Vec3(0, 20 + (i < gaps.size() ? gaps[i] : 0), 0);
    }
    return builder.build();
}

/// The acceptances of these findings of an inspection.
AcceptanceList accepting(const Inspection& found, const std::vector<std::size_t>& findings) {
    AcceptanceList list{{}, "2026-12-24"};
    for (const std::size_t i : findings)
        list.entries.push_back(acceptance_of(found.findings.at(i), found.seams, note));
    return list;
}

/// The sheets, with the findings accepted that `list` covers.
Inspection judged(const SurfaceModel& model, const AcceptanceList& list) {
    Inspection result = inspect(model);
    accept_findings(result, list);
    return result;
}

TEST(Acceptance, TakesAFindingOutOfVerdictAndCounts) {
    const SurfaceModel model = sheets({0.05, 0});
    const Inspection found = judged(model, accepting(inspect(model), {0}));
    EXPECT_EQ(found.verdict, Verdict::pass);
    EXPECT_TRUE(found.findings.empty());
    ASSERT_EQ(found.accepted.size(), 1u);
    EXPECT_EQ(found.accepted[0].accepted->why, "hidden by the trim");
    EXPECT_EQ(outcome_of(found.accepted[0]), "accepted");
    EXPECT_EQ(found.counts, (SeamCounts{.pass = 1, .accepted = 1}));
    EXPECT_EQ(found.accepted_seams, std::vector<std::uint32_t>{0});
    EXPECT_TRUE(found.acceptance_remarks.empty());
    EXPECT_EQ(worst_seams(found, 5), std::vector<std::uint32_t>{1});
}

TEST(Acceptance, LeavesOtherFindings) {
    const SurfaceModel model = sheets({0.05, 0.04});
    const Inspection found = judged(model, accepting(inspect(model), {1}));
    EXPECT_EQ(found.verdict, Verdict::fail);
    ASSERT_EQ(found.findings.size(), 1u);
    EXPECT_NEAR(found.findings[0].worst.value, 0.05, 1e-9);
    EXPECT_EQ(found.counts, (SeamCounts{.fail = 1, .accepted = 1}));
}

TEST(Acceptance, FollowsASeamThatMovesALittleThoughFacesAreRenumbered) {
    AcceptanceList list = accepting(inspect(sheets({0.05})), {0});
    list.entries[0].faces = "face 71 | face 90";
    list.entries[0].reach = test::sheet_length; // a uniform gap is worst anywhere along it
    EXPECT_EQ(judged(sheets({0.05}, {0.3, 0.3, 0.3}), list).verdict, Verdict::pass);
    EXPECT_EQ(judged(sheets({0.05}, {0, 0, 3}), list).verdict, Verdict::fail);
}

TEST(Acceptance, DoesNotCoverWhatHasGrown) {
    AcceptanceList list = accepting(inspect(sheets({0.05})), {0});
    list.entries[0].reach = test::sheet_length; // a uniform gap is worst anywhere along it
    EXPECT_EQ(judged(sheets({0.054}), list).verdict, Verdict::pass);
    const Inspection grown = judged(sheets({0.056}), list);
    EXPECT_EQ(grown.verdict, Verdict::fail);
    ASSERT_EQ(grown.acceptance_remarks.size(), 1u);
    EXPECT_EQ(grown.acceptance_remarks[0].kind, Kind::grown);
    EXPECT_NEAR(grown.acceptance_remarks[0].finding->worst.value, 0.056, 1e-9);
}

TEST(Acceptance, DoesNotCoverACloserLimit) {
    const SurfaceModel model = sheets({0.05, 0});
    for (const auto& [share, covered] : {std::pair(1.0, true), {0.9, true}, {1.01, false}}) {
        AcceptanceList list = accepting(inspect(model), {0});
        list.entries[0].limit *= share;
        const Inspection found = judged(model, list);
        EXPECT_EQ(found.verdict, covered ? Verdict::pass : Verdict::fail) << share;
        ASSERT_EQ(found.acceptance_remarks.size(), covered ? 0u : 1u);
        if (!covered) {
            EXPECT_EQ(found.acceptance_remarks[0].kind, Kind::held_closer);
        }
    }
}

/// A closer limit of a smallest value is larger.
TEST(Acceptance, OfASmallestValueDoesNotCoverALargerLimit) {
    Check draft;
    draft.code = "KEIKO-DRAFT", draft.worst.value = 0.4, draft.worst.limit = 0.5;
    draft.worst.at_least = true, draft.worst.verdict = Verdict::fail;
    for (const auto& [limit, covered] : {std::pair(0.5, true), {0.6, true}, {0.45, false}}) {
        AcceptanceList list{{acceptance_of(draft, {}, note)}, "2026-12-24"};
        list.entries[0].limit = limit;
        std::vector<Check> checks{draft};
        EXPECT_EQ(accept(checks, list, {}).empty(), covered) << limit;
    }
}

TEST(Acceptance, DoesNotCoverALongerStretch) {
    AcceptanceList list = accepting(inspect(sheets({0.05})), {0});
    list.entries[0].stretch->length /= 1.2;
    const Inspection longer = judged(sheets({0.05}), list);
    EXPECT_EQ(longer.verdict, Verdict::fail);
    EXPECT_EQ(longer.acceptance_remarks.at(0).kind, Kind::grown);
}

/// The worst places of two seams that meet lie at one corner.
TEST(Acceptance, DoesNotCoverAnotherSeamThatPassesItsPlace) {
    const Inspection before = inspect(sheets({0.05}));
    AcceptanceList list = accepting(before, {0});
    list.entries[0].stretch->middle = before.findings[0].worst.place + Vec3(0, 30, 0);
    const Inspection other = judged(sheets({0.05}), list);
    EXPECT_EQ(other.verdict, Verdict::fail);
    EXPECT_EQ(other.acceptance_remarks.at(0).kind, Kind::unused);
}

TEST(Acceptance, CoversOneFindingAtMost) {
    Inspection found = inspect(sheets({0.05}));
    const AcceptanceList list = accepting(found, {0});
    Check twin = found.checks.front();
    twin.faces = "face 8 | face 9";
    std::vector<Check> checks{twin, found.checks.front()};
    EXPECT_TRUE(accept(checks, list, found.seams).empty());
    EXPECT_FALSE(checks[0].is_accepted());
    EXPECT_TRUE(checks[1].is_accepted());
}

TEST(Acceptance, EndsWithItsLastDay) {
    const SurfaceModel model = sheets({0.05});
    AcceptanceList list = accepting(inspect(model), {0});
    list.today = "2027-01-31";
    EXPECT_EQ(judged(model, list).verdict, Verdict::pass);
    list.today = "2027-02-01";
    const Inspection after = judged(model, list);
    EXPECT_EQ(after.verdict, Verdict::fail);
    EXPECT_EQ(after.acceptance_remarks.at(0).kind, Kind::expired);
    list.entries[0].note.until.clear();
    EXPECT_EQ(judged(model, list).verdict, Verdict::pass);
}

TEST(Acceptance, IsReportedWhereItsFindingIsGone) {
    const AcceptanceList list = accepting(inspect(sheets({0.05})), {0});
    const Inspection mended = judged(sheets({0}), list);
    EXPECT_EQ(mended.verdict, Verdict::pass);
    EXPECT_EQ(mended.acceptance_remarks.at(0).kind, Kind::unused);
}

TEST(Acceptance, OfWhatWasUndecidedCoversNoFailure) {
    const SurfaceModel model = sheets({0.05});
    AcceptanceList list = accepting(inspect(model), {0});
    list.entries[0].verdict = Verdict::undecided;
    const Inspection found = judged(model, list);
    EXPECT_EQ(found.verdict, Verdict::fail);
    EXPECT_EQ(found.acceptance_remarks.at(0).kind, Kind::grown);
}

TEST(Acceptance, DoesNotPassLostFaces) {
    SurfaceModel model = sheets({0.05});
    model.lost_faces.push_back({9, "rear", "no surface"});
    EXPECT_EQ(judged(model, accepting(inspect(model), {0})).verdict, Verdict::undecided);
}

/// A verdict that no finding explains is not accepted with one.
TEST(Acceptance, KeepsAVerdictWithoutAFinding) {
    const SurfaceModel model = sheets({0.05, 0});
    Inspection found = inspect(model);
    const AcceptanceList list = accepting(found, {0});
    found.seams[1].verdict = Verdict::undecided;
    accept_findings(found, list);
    EXPECT_EQ(found.verdict, Verdict::undecided);
    EXPECT_EQ(found.counts.undecided, 1u);
}

TEST(Acceptance, OfASmallestValueCoversNoSmallerOne) {
    CriteriaPreset preset;
    preset.structure.small_face = 1000;
    const SurfaceModel model = sheets({0});
    Inspection found = inspect(model, preset);
    ASSERT_EQ(found.findings.size(), 2u);
    AcceptanceList list = accepting(found, {0, 1});
    list.entries[0].value *= 1.2;
    accept_findings(found, list);
    EXPECT_EQ(found.accepted.size(), 1u);
    EXPECT_EQ(found.acceptance_remarks.at(0).kind, Kind::grown);
    EXPECT_EQ(found.face_counts.accepted, 1u);
    EXPECT_EQ(found.verdict, Verdict::fail);
}

} // namespace
} // namespace keiko
