#include "keiko/report/content/inspection_texts.h"
#include "keiko/report/content/line_list.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace keiko {
namespace {

LineCrossing crossing(const std::string& faces, double turn, Verdict verdict) {
    LineCrossing c;
    c.faces = faces, c.to = 1, c.place = {turn, 2, 3};
    c.turn = {-turn, 1e-6, 0.1, verdict};
    c.kink = {1, 1e-6, 5.7, Verdict::pass};
    c.jump = {0.3, 1e-6, std::nullopt, Verdict::pass};
    c.verdict = verdict;
    return c;
}

LineList list() {
    LineList lines;
    ViewLines front;
    front.view = "front";
    front.found.crossings = {crossing("face 1 | face 2", 0.4, Verdict::fail),
                             crossing("face 1 | face 2", 0.2, Verdict::fail),
                             crossing("face 1 | face 2", 0.05, Verdict::pass),
                             crossing("face 2 | face 3", 0.1, Verdict::undecided)};
    LineCrossing lost; // ends at a seam, nobody knows why
    lost.faces = "face 5 | face 6";
    front.found.crossings.push_back(lost);
    ViewLines side = front;
    side.view = "side";
    side.found.crossings = {crossing("face 1 | face 2", 0.01, Verdict::pass)};
    lines.views = {front, side};
    return lines;
}

TEST(LineChecks, AreTheWorstOfEachSeamViewAndLimit) {
    const std::vector<Check> checks = line_checks(list());
    ASSERT_EQ(checks.size(), 6u); // turn and kink of two seams and one
    const Check& worst = checks[0];
    EXPECT_EQ(worst.code, "KEIKO-LINE-TURN");
    EXPECT_EQ(worst.view, "front");
    EXPECT_EQ(worst.faces, "face 1 | face 2");
    EXPECT_EQ(worst.worst.value, 0.4);
    EXPECT_EQ(worst.worst.place, Vec3(0.4, 2, 3));
    EXPECT_EQ(worst.worst.verdict, Verdict::fail);
    EXPECT_EQ(worst.message,
              "the turn of a line of 0.4 degrees is over the limit of 0.1 degrees; of "
              "3 lines 2 not within it");
    EXPECT_EQ(checks[1].code, "KEIKO-LINE-KINK");
    EXPECT_FALSE(checks[1].is_finding());
    EXPECT_EQ(checks[2].worst.verdict, Verdict::undecided);
    EXPECT_EQ(checks[4].view, "side");
}

TEST(LineChecks, KnowOnlyTheTurnOfALineThatIsNotContinued) {
    LineList lines;
    lines.views.emplace_back();
    LineCrossing broken = crossing("face 1 | face 2", 3, Verdict::fail);
    broken.to = no_index;
    lines.views[0].found.crossings = {broken};
    const std::vector<Check> checks = line_checks(lines);
    ASSERT_EQ(checks.size(), 1u);
    EXPECT_EQ(checks[0].code, "KEIKO-LINE-TURN");
}

TEST(LineChecks, StandInJUnitAndSarifBesideThoseOfTheGeometry) {
    const Inspection both = with_lines(inspect(SurfaceModel{}), list());
    EXPECT_EQ(both.verdict, Verdict::fail);
    EXPECT_EQ(both.findings.size(), 2u);
    const std::string xml = junit_xml(both);
    EXPECT_NE(xml.find("name=\"lines over face 1 | face 2 in view front: line_turn\">\n"
                       "      <failure type=\"KEIKO-LINE-TURN\""),
              std::string::npos)
        << xml;
    const std::vector<std::filesystem::path> files{"a.step"};
    const auto run = nlohmann::json::parse(sarif_json(both, "1", files))["runs"][0];
    ASSERT_EQ(run["results"].size(), 2u);
    EXPECT_EQ(run["results"][0]["ruleId"], "KEIKO-LINE-TURN");
    EXPECT_EQ(run["results"][0]["level"], "error");
    EXPECT_EQ(run["results"][1]["level"], "warning");
    const auto& place = run["results"][0]["locations"][0]["logicalLocations"][0];
    EXPECT_EQ(place["kind"], "seam");
    EXPECT_EQ(place["fullyQualifiedName"], "lines over face 1 | face 2 in view front");
    EXPECT_EQ(run["results"][0]["locations"][0]["physicalLocation"]["region"]["startLine"], 1);
}

} // namespace
} // namespace keiko
