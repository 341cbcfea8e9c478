#include "keiko/base/text.h"
#include "keiko/report/content/inspection_texts.h"

#include "tests/support/analytic_models.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>

namespace keiko {
namespace {

using Paths = std::vector<std::filesystem::path>;

/// One seam with a gap of 0.05 mm between faces with awkward names, one lost face.
Inspection inspection() {
    test::ModelBuilder builder;
    builder.plane({0, 0.05, 0}, {100, 0, 0}, {0, 50, 0});
    builder.plane({0, 0, 0}, {100, 0, 0}, {0, -50, 0});
    SurfaceModel model = builder.build();
    model.source = "door \"left\".step";
    model.faces[0].name = "a<b>, \"c\"";
    model.faces[1].name = "K\xfcgel\x01";
    model.lost_faces.push_back({7, "rear", "no <surface>"});
    return inspect(model);
}

std::size_t count(const std::string& text, std::string_view what) {
    std::size_t found = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
        ++found;
    return found;
}

TEST(JUnitXml, HasACaseForEachCheckAndEachLostFace) {
    const std::string xml = junit_xml(inspection());
    EXPECT_EQ(count(xml, "<testcase "), 4u);
    EXPECT_NE(xml.find("tests=\"4\" failures=\"1\" errors=\"1\" skipped=\"1\""), std::string::npos)
        << xml;
    EXPECT_NE(
        xml.find("<failure type=\"G-SU-LG\" message=\"the gap of 0.05 mm is over the limit of "
                 "0.01 mm\">"),
        std::string::npos);
    EXPECT_NE(xml.find("<error type=\"lost\" message=\"no &lt;surface&gt;\"/>"), std::string::npos);
}

TEST(JUnitXml, EscapesNames) {
    const std::string xml = junit_xml(inspection());
    EXPECT_NE(xml.find("classname=\"door &quot;left&quot;.step\""), std::string::npos);
    EXPECT_NE(xml.find("a&lt;b&gt;, &quot;c&quot;"), std::string::npos);
    EXPECT_NE(xml.find("K\xef\xbf\xbdgel "), std::string::npos);
}

TEST(JUnitXml, TellsWhatIsUndecidedAsAnError) {
    Inspection near = inspection();
    near.facts.lost_faces.clear();
    near.checks[0].worst.verdict = Verdict::undecided;
    const std::string xml = junit_xml(near);
    EXPECT_NE(xml.find("failures=\"0\" errors=\"1\""), std::string::npos);
    EXPECT_NE(xml.find("<error type=\"G-SU-LG\""), std::string::npos);
}

TEST(SarifJson, EscapesThePathOfItsOnlyFile) {
    const auto log = nlohmann::json::parse(
        sarif_json(inspection(), "9.9", Paths{"parts/door \"left\" \xc3\xbc.step"}));
    const auto& run = log["runs"][0];
    EXPECT_EQ(run["tool"]["driver"]["version"], "9.9");
    const auto& artifact =
        run["results"][0]["locations"][0]["physicalLocation"]["artifactLocation"];
    EXPECT_EQ(artifact["uri"], "parts/door%20%22left%22%20%C3%BC.step");
    EXPECT_EQ(run["artifacts"][0]["location"]["uri"], artifact["uri"]);
    EXPECT_EQ(run["invocations"][0]["toolExecutionNotifications"].size(), 1u);
}

/// Two files of one face each, which meet with a gap of 0.05 mm.
Inspection of_two_files() {
    test::ModelBuilder upper, lower;
    upper.plane({0, 0.05, 0}, {100, 0, 0}, {0, 50, 0});
    lower.plane({0, 0, 0}, {100, 0, 0}, {0, -50, 0});
    SurfaceModel models[] = {upper.build(), lower.build()};
    models[0].source = "a.step", models[1].source = "b.step";
    models[0].faces[0].line = 12, models[1].faces[0].name = "sill";
    return inspect(merge(models));
}

nlohmann::json run_of(const Inspection& inspection) {
    const Paths files(inspection.facts.files.begin(), inspection.facts.files.end());
    return nlohmann::json::parse(sarif_json(inspection, "1", files))["runs"][0];
}

TEST(SarifJson, PutsASeamOfTwoFilesIntoTheFirstAndRelatesTheOther) {
    const auto run = run_of(of_two_files());
    EXPECT_EQ(run["artifacts"].size(), 2u);
    const auto& result = run["results"][0];
    const auto& first = result["locations"][0]["physicalLocation"];
    EXPECT_EQ(first["artifactLocation"]["uri"], "a.step");
    EXPECT_EQ(first["region"]["startLine"], 12);
    ASSERT_EQ(result["relatedLocations"].size(), 1u);
    const auto& related = result["relatedLocations"][0];
    EXPECT_EQ(related["physicalLocation"]["artifactLocation"]["uri"], "b.step");
    EXPECT_EQ(related["physicalLocation"]["artifactLocation"]["index"], 1);
    EXPECT_EQ(related["physicalLocation"]["region"]["startLine"], 1);
    EXPECT_EQ(related["message"]["text"], "sill");
}

TEST(SarifJson, GivesAbsolutePathsRelativeToTheRoot) {
    const auto run =
        nlohmann::json::parse(sarif_json(inspection(), "1", Paths{"/parts/a b.step"}))["runs"][0];
    const auto& artifact = run["artifacts"][0]["location"];
    EXPECT_EQ(artifact["uri"], "parts/a%20b.step");
    EXPECT_EQ(artifact["uriBaseId"], "ROOT");
    EXPECT_EQ(run["originalUriBaseIds"]["ROOT"]["uri"], "file:///");
    EXPECT_TRUE(run_of(of_two_files())["originalUriBaseIds"].empty());
}

TEST(SarifJson, HasFingerprintsOfCodeAndFacesNotOfNumbers) {
    const auto hash = [](const Inspection& found, std::size_t i) {
        return run_of(found)["results"][i]["partialFingerprints"]["primaryLocationLineHash"]
            .get<std::string>();
    };
    const Inspection plain = of_two_files();
    Inspection moved = plain;
    moved.findings[0].worst.value *= 2, moved.findings[0].message = "grown";
    EXPECT_EQ(hash(moved, 0), hash(plain, 0));
    Inspection renamed = plain;
    renamed.facts.face_list[0].name = "fender";
    EXPECT_NE(hash(renamed, 0), hash(plain, 0));
    Inspection twice = plain;
    twice.findings.push_back(twice.findings[0]);
    EXPECT_EQ(hash(twice, 0), hash(plain, 0));
    EXPECT_NE(hash(twice, 1), hash(twice, 0));
}

TEST(SarifJson, KeepsTheWorstOfMoreResultsThanGitHubTakes) {
    Inspection many = of_two_files();
    Check undecided = many.findings[0];
    undecided.worst.verdict = Verdict::undecided;
    many.findings.assign(most_sarif_results + 2, undecided);
    many.findings.back().worst.verdict = Verdict::fail;
    const auto run = run_of(many);
    ASSERT_EQ(run["results"].size(), most_sarif_results);
    EXPECT_EQ(run["results"][0]["level"], "error");
    const auto& notes = run["invocations"][0]["toolExecutionNotifications"];
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_EQ(notes[0]["message"]["text"],
              "2 of 25002 findings are left out: a run has at most 25000 results");
}

TEST(SarifJson, ExplainsEveryRule) {
    for (const auto& rule : run_of(of_two_files())["tool"]["driver"]["rules"])
        for (const char* key : {"shortDescription", "fullDescription", "help"})
            EXPECT_FALSE(rule[key]["text"].get<std::string>().empty()) << rule["id"];
}

/// In messages braces stand for arguments, and brackets before parentheses for links.
TEST(SarifJson, MarksBracesAndLinksOfNames) {
    Inspection named = inspection();
    named.findings[0].faces = "face {0} [a](b) [c]";
    const auto log = nlohmann::json::parse(sarif_json(named, "1", Paths{"a.step"}));
    const auto& result = log["runs"][0]["results"][0];
    EXPECT_TRUE(result["message"]["text"].get<std::string>().starts_with(
        "face {{0}} [a\\](b) [c]: the gap of"));
    EXPECT_EQ(result["locations"][0]["logicalLocations"][0]["name"], "face {0} [a](b) [c]");
}

TEST(SarifJson, WarnsOfWhatIsUndecided) {
    Inspection near = inspection();
    near.findings[0].worst.verdict = Verdict::undecided;
    const auto log = nlohmann::json::parse(sarif_json(near, "1", Paths{"a.step"}));
    EXPECT_EQ(log["runs"][0]["results"][0]["level"], "warning");
    EXPECT_EQ(log["runs"][0]["results"][0]["properties"]["verdict"], "undecided");
}

TEST(SarifJson, HasAnEmptyListOfResultsWhereAllPasses) {
    const auto log =
        nlohmann::json::parse(sarif_json(inspect(SurfaceModel{}), "1", Paths{"a.bpt"}));
    EXPECT_EQ(log["runs"][0]["results"], nlohmann::json::array());
}

/// Two dents on one face are two cases.
TEST(JUnitXml, NamesEveryCaseApart) {
    Inspection dented = inspection();
    Check dent = dented.checks.front();
    dent.seam = no_index, dent.face = 0, dent.faces = "face 1", dent.quantity = "dent";
    dented.checks = {dent, dent, dent};
    const std::string xml = junit_xml(dented);
    for (const char* name :
         {"name=\"face 1: dent\"", "name=\"face 1: dent 2\"", "name=\"face 1: dent 3\""})
        EXPECT_EQ(count(xml, name), 1u) << xml;
}

TEST(ChecksCsv, QuotesFieldsThatNeedIt) {
    const std::string csv = checks_csv(inspection());
    EXPECT_EQ(count(csv, "\r\n"), 4u);
    EXPECT_NE(
        csv.find("\r\n1,,\"face 1 (a<b>, \"\"c\"\") | face 2 (K\xef\xbf\xbdgel\x01)\",G-SU-LG,gap,"
                 "fail,0.05"),
        std::string::npos)
        << csv;
    EXPECT_NE(csv.find("curvature,not judged,,,,,,,,,the curvature is not judged"),
              std::string::npos)
        << csv;
}

/// A rod that is bent tighter than its preset allows.
Inspection tight_face() {
    CriteriaPreset preset;
    preset.surface.minimum_radius = 0.5;
    return inspect(test::cylinder_model(test::stretched({0.4, 0.4, 20}, {0, 0, 1}, Vec3(0))),
                   preset);
}

TEST(ChecksCsv, HasNoSeamForACheckOfAFace) {
    const std::string csv = checks_csv(tight_face());
    EXPECT_NE(csv.find("\n,,face 1,G-SU-CR,radius,fail,0."), std::string::npos) << csv;
}

TEST(SarifJson, NamesTheFaceThatACheckIsOf) {
    const auto log = nlohmann::json::parse(sarif_json(tight_face(), "1", Paths{"rod.step"}));
    const auto& result = log["runs"][0]["results"][0];
    EXPECT_EQ(result["ruleId"], "G-SU-CR");
    const auto& place = result["locations"][0]["logicalLocations"][0];
    EXPECT_EQ(place["kind"], "face");
    EXPECT_EQ(place["fullyQualifiedName"], "face 1");
}

TEST(InspectionText, CountsFacesWhereTheyAreJudged) {
    const std::string text = inspection_text(tight_face(), 0);
    EXPECT_TRUE(
        text.starts_with("fail: stretches of seams 0 fail, 0 undecided, 1 pass, 0 creases; "))
        << text;
    const auto faces = text.find("; faces 1 fail, 0 undecided, 0 pass; by ");
    EXPECT_LT(faces, text.find('\n')) << text;
}

TEST(InspectionText, StatesOfHowManySeamsItCountsStretches) {
    Inspection three = inspection();
    three.seams.resize(3), three.facts.seams = 2;
    three.counts = {.fail = 1, .undecided = 0, .pass = 1, .creases = 1};
    EXPECT_TRUE(seams_words(three).starts_with(
        "stretches of seams 1 fail, 0 undecided, 1 pass, 1 creases (of 2 seams)"))
        << seams_words(three);
    three.facts.seams = 3;
    EXPECT_EQ(seams_words(three).find("(of"), std::string::npos);
}

TEST(InspectionText, TellsTheFirstFindingsAndHowManyMoreThereAre) {
    Inspection many = inspection();
    many.findings.assign(25, many.findings[0]);
    const std::string text = inspection_text(many, 3);
    EXPECT_EQ(count(text, "fail  G-SU-LG"), 3u);
    EXPECT_NE(text.find("and 22 more findings"), std::string::npos);
}

TEST(Utf8, AcceptsWhatXmlAndUnicodeAllow) {
    for (const char* right : {"a", "\xc3\xbc", "\xe8\x9b\x8d", "\xf0\x9f\x9a\x97", "\xed\x9f\xbf"})
        EXPECT_EQ(utf8_length(right), std::string_view(right).size()) << right;
    for (const char* wrong :
         {"\xfc", "\xc0\x80", "\xe0\x80\x80", "\xed\xa0\x80", "\xf0\x80\x80\x80",
          "\xf4\x90\x80\x80", "\xef\xbf\xbf", "\xe8\x9b", "\x80"})
        EXPECT_EQ(utf8_length(wrong), 0u);
    EXPECT_EQ(as_utf8("K\xfcgel"), "K\xef\xbf\xbdgel");
}

} // namespace
} // namespace keiko
