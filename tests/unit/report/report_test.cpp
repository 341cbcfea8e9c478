#include "keiko/report/report.h"

#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/base/units.h"
#include "keiko/report/facts_text.h"
#include "keiko/report/report_html.h"
#include "keiko/report/report_json.h"

#include "tests/support/model_builder.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace keiko {
namespace {

/// Two sheets with a gap of 0.04 mm, then one at 0.3 degrees, then a crease.
SurfaceModel model() {
    test::ModelBuilder builder;
    builder.plane({0, 0.04, 0}, {100, 0, 0}, {0, 50, 0});
    builder.plane({0, 0, 0}, {100, 0, 0}, {0, -50, 0});
    const auto down = [](double degrees) {
        const double angle = degrees_to_radians(degrees);
        return Vec3(0, -50 * std::cos(angle), -50 * std::sin(angle));
    };
    builder.plane({0, -50, 0}, {100, 0, 0}, down(0.3));
    builder.plane(Vec3(0, -50, 0) + down(0.3), {100, 0, 0}, down(40));
    SurfaceModel result = builder.build();
    result.source = "door <left>.step";
    result.faces[1].name = "A&B";
    result.lost_faces.push_back({7, "rear", "no surface"});
    result.repairs.push_back({2, RepairKind::loop_closed, 1, 0.25, ""});
    result.repairs.push_back({2, RepairKind::by_reader, 3, 0, "a <seam> added"});
    result.diagnostics.push_back({Severity::note, "face 2", "invalid in the file"});
    return result;
}

Report report() {
    Report result;
    result.tool_version = "9.9";
    result.inspection = inspect(model());
    result.coverage = CoverageSummary{"auto.toml", 0.875, {"face 4"}};
    ReportPicture picture{"front", "12 lamps", "front.png",  "not really a PNG",
                          200,     100,        {{1, 50, 25}}};
    result.pictures.push_back(picture);
    picture.file_name = "seam-1.png", picture.markers.clear();
    result.close_ups.push_back({0, picture});
    return result;
}

TEST(ReportJson, ListsRepairsByFaceAndKind) {
    const auto json = nlohmann::json::parse(report_json(report()))["model"];
    ASSERT_EQ(json["repairs"].size(), 2u);
    EXPECT_EQ(json["repairs"][0],
              (nlohmann::json{{"face", 2}, {"kind", "loop_closed"}, {"count", 1}, {"size", 0.25}}));
    EXPECT_EQ(json["repairs"][1]["detail"], "a <seam> added");
    EXPECT_EQ(json["repair_totals"]["by_reader"]["count"], 3);
}

TEST(ReportJson, HoldsVerdictCountsAndMeasures) {
    const auto json = nlohmann::json::parse(report_json(report()));
    EXPECT_EQ(json["format"], "keiko-report/1");
    EXPECT_EQ(json["tool"]["version"], "9.9");
    EXPECT_EQ(json["verdict"], "fail");
    EXPECT_EQ(json["counts"]["fail"], 2);
    EXPECT_EQ(json["counts"]["creases"], 1);
    ASSERT_EQ(json["seams"].size(), 3u);
    EXPECT_NEAR(json["seams"][0]["gap"]["value"].get<double>(), 0.04, 1e-12);
    EXPECT_EQ(json["seams"][0]["gap"]["limit"], 0.01);
    EXPECT_NEAR(json["seams"][1]["angle"]["value"].get<double>(), 0.3, 1e-9);
    EXPECT_TRUE(json["seams"][1]["curvature"].is_null()); // its angle fails
    EXPECT_EQ(json["seams"][1]["face_ids"], nlohmann::json({2, 3}));
    EXPECT_TRUE(json["seams"][2]["crease"]);
    EXPECT_EQ(json["findings"][0]["code"], "G-SU-LG");
    EXPECT_EQ(json["findings"][1]["quantity"], "angle");
    EXPECT_EQ(json["worst_seams"], nlohmann::json({0, 1}));
    EXPECT_EQ(json["coverage"]["covered"], 0.875);
    EXPECT_EQ(json["pictures"][0]["markers"][0]["number"], 1);
    EXPECT_EQ(json["close_ups"][0]["seam"], 0);
    EXPECT_EQ(json["model"]["lost_faces"][0]["id"], 7);
    EXPECT_EQ(json["model"]["degrees"][0]["patches"], 4);
}

TEST(ReportJson, KeepsNumbersInFullPrecision) {
    const Report original = report();
    const auto json = nlohmann::json::parse(report_json(original));
    EXPECT_EQ(json["seams"][1]["angle"]["value"].get<double>(),
              original.inspection.seams[1].angle->value);
}

TEST(ReportJson, SurvivesNamesThatAreNoUtf8) {
    Report broken = report();
    broken.inspection.seams[0].faces = "K\xfcgel";
    EXPECT_TRUE(nlohmann::json::accept(report_json(broken)));
}

TEST(ReportJson, ServesInfoAndCheckWithTheSameKeys) {
    const Inspection inspection = inspect(model());
    const auto check = nlohmann::json::parse(inspection_json(inspection));
    const auto info = nlohmann::json::parse(facts_json(inspection.facts));
    EXPECT_EQ(check["format"], "keiko-inspection/1");
    EXPECT_FALSE(check.contains("pictures"));
    EXPECT_EQ(info["format"], "keiko-model-facts/1");
    EXPECT_EQ(info["faces"], check["model"]["faces"]);
    EXPECT_TRUE(info["unit"].is_null());
    EXPECT_EQ(info["millimetres_per_unit"], 1);
    EXPECT_EQ(info["part_list"][0]["faces"], info["faces"]);
    EXPECT_EQ(info["face_list"].size(), info["faces"]);
    EXPECT_EQ(info["face_list"][1]["name"], "A&B");
    EXPECT_EQ(info["remarks"]["notes"], 1);
    EXPECT_FALSE(check["model"].contains("face_list"));
}

TEST(ReportJson, TellsOfTheTracerWhereThereWasOne) {
    Report traced = report();
    EXPECT_TRUE(nlohmann::json::parse(report_json(traced))["model"]["tracing"].is_null());
    traced.inspection.facts.tracing =
        trace_facts({.leaves = 9, .leaves_mixed = 2, .bytes = 1 << 20, .build_seconds = 3});
    const auto tracing = nlohmann::json::parse(report_json(traced))["model"]["tracing"];
    EXPECT_EQ(tracing["leaves"], 9);
    EXPECT_EQ(tracing["mixed_leaves"], 2);
    EXPECT_FALSE(tracing.contains("build_milliseconds"));
    EXPECT_NE(report_html(traced).find("9 leaves, 2 cut by trims, 1.00 MiB"), std::string::npos);
}

TEST(FactsText, TellsTheBuildTimeOfATracer) {
    ModelFacts facts = report().inspection.facts;
    EXPECT_EQ(facts_text(facts).find("tracing"), std::string::npos);
    facts.tracing = timed_trace_facts({.leaves = 9, .bytes = 512, .build_seconds = 0.25});
    EXPECT_NE(facts_text(facts).find("9 leaves, 0 cut by trims, 0 trimmed away, 512 bytes, built "
                                     "in 250 ms"),
              std::string::npos);
}

TEST(ReportHtml, TellsTheFirstScreenInOrder) {
    const std::string html = report_html(report());
    std::size_t at = 0;
    for (const char* text :
         {"<header class=\"card head fail\">", "seams fail", "undecided", "creases", "not covered",
          "Reflections", "Worst seams", "0.0400 mm", "0.300°", "Coverage", "87.5 %", "All seams",
          "lost faces", "repairs", "1 × open loop closed on 1 face, up to 0.25 mm",
          "a &lt;seam&gt; added", "invalid in the file"}) {
        const std::size_t next = html.find(text, at);
        ASSERT_NE(next, std::string::npos) << text;
        at = next;
    }
}

/// The first seam smooth up to its curvature, whose slope jumps by 0.4 degrees.
Report with_slope_failure() {
    Report sloped = report();
    sloped.inspection.preset.curvature_slope = 0.1;
    MeasuredSeam& seam = sloped.inspection.seams[0];
    seam.gap = {.value = 0, .bound = 0, .limit = 0.01};
    seam.curvature = CurvatureStep{};
    seam.curvature->worst.limit = 0.1;
    seam.slope = CurvatureSlopeStep{};
    seam.slope->worst = {.value = 0.4, .bound = 0, .limit = 0.1, .verdict = Verdict::fail};
    seam.severity = 4;
    return sloped;
}

TEST(ReportHtml, TellsWhyASeamFailsByTheSlopeOfItsCurvatureAlone) {
    const std::string html = report_html(with_slope_failure());
    EXPECT_NE(html.find("<div class=\"measure fail\"><span class=\"soft\">curvature's slope</span> "
                        "<b>0.400°</b>"),
              std::string::npos);
    EXPECT_NE(html.find("limit 0.1°</span>"), std::string::npos);
    EXPECT_NE(html.find(">its slope ° ≤ 0.1<"), std::string::npos);
    EXPECT_NE(html.find("<td class=\"tone\" data-v=\"0.4\">0.400</td>"), std::string::npos);
    EXPECT_EQ(report_html(report()).find("its slope °"), std::string::npos);
}

TEST(ReportHtml, TellsOverlapsAndKnotLinesFromGapsAndSeams) {
    Report odd = report();
    odd.inspection.seams[0].overlap = true;
    odd.inspection.seams[1].internal = true;
    const std::string html = report_html(odd);
    EXPECT_NE(html.find("<span class=\"soft\">overlap</span> <b>0.0400 mm</b>"), std::string::npos);
    EXPECT_NE(html.find("a knot line inside the face"), std::string::npos);
    EXPECT_NE(html.find("data-v=\"seam, overlap\""), std::string::npos);
    EXPECT_NE(html.find("data-v=\"knot line\""), std::string::npos);
}

TEST(ReportHtml, HeadsTheColumnsWithTheirLimits) {
    const std::string html = report_html(report());
    for (const char* heading : {">gap mm ≤ 0.01<", ">angle ° ≤ 0.1<", ">curvature ≤ 10 %<"})
        EXPECT_NE(html.find(heading), std::string::npos) << heading;
}

TEST(ReportHtml, EscapesNamesAndNeedsNoOtherFile) {
    const std::string html = report_html(report());
    EXPECT_NE(html.find("door &lt;left&gt;.step"), std::string::npos);
    EXPECT_EQ(html.find("<left>"), std::string::npos);
    EXPECT_NE(html.find("A&amp;B"), std::string::npos);
    EXPECT_NE(html.find("data:image/png;base64,bm90IHJlYWxseSBhIFBORw=="), std::string::npos);
    for (const char* outside : {"http://", "https://", "src=\"front", "<link", "@import"})
        EXPECT_EQ(html.find(outside), std::string::npos) << outside;
}

TEST(ReportHtml, PutsMarkersInSharesOfThePicture) {
    EXPECT_NE(report_html(report()).find("left:25.00%;top:25.00%\">1<"), std::string::npos);
}

TEST(ReportHtml, LeavesOutWhatThereIsNot) {
    Report bare;
    bare.inspection = inspect(SurfaceModel{});
    const std::string html = report_html(bare);
    for (const char* absent : {"Reflections", "Worst seams", "Coverage", "not covered"})
        EXPECT_EQ(html.find(absent), std::string::npos) << absent;
    EXPECT_NE(html.find("<header class=\"card head pass\">"), std::string::npos);
}

TEST(WriteReport, WritesEveryFileAndTheSameBytesAgain) {
    const std::filesystem::path folder =
        std::filesystem::path(testing::TempDir()) / "keiko-report" / "deep";
    std::filesystem::remove_all(folder);
    write_report(folder, report());
    const std::string html = read_file(folder / "report.html");
    const std::string json = read_file(folder / "report.json");
    EXPECT_EQ(read_file(folder / "front.png"), "not really a PNG");
    EXPECT_TRUE(std::filesystem::exists(folder / "seam-1.png"));
    write_report(folder, report());
    EXPECT_EQ(read_file(folder / "report.html"), html);
    EXPECT_EQ(read_file(folder / "report.json"), json);
    std::filesystem::remove_all(folder.parent_path());
}

TEST(WriteReport, NamesTheFolderItCannotMake) {
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "keiko-in-way";
    write_report(file.parent_path() / "keiko-ok", Report{});
    std::filesystem::copy_file(file.parent_path() / "keiko-ok" / "report.json", file,
                               std::filesystem::copy_options::overwrite_existing);
    EXPECT_THROW(write_report(file / "sub", Report{}), Error);
    std::filesystem::remove_all(file);
    std::filesystem::remove_all(file.parent_path() / "keiko-ok");
}

} // namespace
} // namespace keiko
