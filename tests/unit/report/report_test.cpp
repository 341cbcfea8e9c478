#include "keiko/report/report.h"

#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/base/units.h"
#include "keiko/report/facts_text.h"
#include "keiko/report/lines_json.h"
#include "keiko/report/report_html.h"
#include "keiko/report/report_json.h"

#include "tests/support/model_builder.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

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
    result.close_ups.push_back({CloseUp::Of::seam, 0, picture});
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

TEST(ReportHtml, RowsOfFindingsOpenTheirCloseUps) {
    Report with_faces = report();
    ReportPicture dent{"close-up-2", "", "close-up-2.png", "a dent", 360, 240, {}};
    with_faces.close_ups[0].picture.title = "close-up-1";
    with_faces.close_ups.push_back({CloseUp::Of::face, 1, dent});
    const std::string html = report_html(with_faces);
    EXPECT_NE(html.find("data-shot=\"close-up-1\""), std::string::npos);
    EXPECT_NE(html.find("data-shot=\"close-up-2\""), std::string::npos);
    EXPECT_NE(html.find("<img id=\"close-up-1\""), std::string::npos);
    // The seam's is in its card, the face's in the gallery.
    EXPECT_LT(html.find("<img id=\"close-up-1\""), html.find("<div hidden>"));
    EXPECT_GT(html.find("<img id=\"close-up-2\""), html.find("<div hidden>"));
    EXPECT_NE(html.find("<dialog id=\"viewer\">"), std::string::npos);
    const auto json = nlohmann::json::parse(report_json(with_faces));
    EXPECT_EQ(json["close_ups"][1]["face"], 1);
}

TEST(ReportHtml, TellsOfInflectionCurvesAndCombs) {
    Report bent = report();
    bent.inspection.faces[0].inflections.push_back(
        {false, true, 12.5, 1e-5, 0.001, {Vec3(1, 2, 3), Vec3(4, 5, 6), Vec3(7, 8, 9)}});
    bent.combs.push_back({"y=120", "<svg>comb</svg>"});
    const std::string html = report_html(bent);
    EXPECT_NE(html.find("inflections mm"), std::string::npos);
    EXPECT_NE(html.find("in 1 at 4.0, 5.0, 6.0"), std::string::npos);
    EXPECT_NE(html.find("<svg>comb</svg>"), std::string::npos);
    EXPECT_EQ(report_files(bent).at("combs-y=120.svg"), "<svg>comb</svg>");
    const auto curve = nlohmann::json::parse(report_json(bent))["faces"][0]["inflections"][0];
    EXPECT_EQ(curve["length"], 12.5);
    EXPECT_EQ(curve["points"][1], nlohmann::json({4, 5, 6}));
}

/// Two views; in the second a line jumps by 4 mm, in the first two pass, one of them all but.
LineList lines() {
    LineList list;
    list.rig = "tubes & more";
    list.views.resize(2);
    list.views[0].view = "front", list.views[1].view = "top";
    const auto add = [&](ViewLines& view, const char* faces, Verdict verdict, double severity) {
        LineCrossing crossing;
        crossing.faces = faces;
        crossing.to = 1;
        crossing.turn = {-0.25, 1e-6, 0.1, verdict};
        crossing.jump = {4, 1e-6, std::nullopt, Verdict::pass};
        crossing.verdict = verdict;
        crossing.severity = severity;
        view.found.crossings.push_back(crossing);
    };
    add(list.views[0], "near", Verdict::pass, 0.9);
    add(list.views[0], "good", Verdict::pass, 0.1);
    add(list.views[1], "bad <1>", Verdict::fail, 2.5);
    LineCrossing lost;
    list.views[1].found.crossings.push_back(lost);
    return list;
}

TEST(Lines, AreRankedThroughAllViewsAndThoseWithoutAVerdictAreNot) {
    const LineList list = lines();
    const std::vector<CrossingPlace> ranked = ranked_crossings(list);
    ASSERT_EQ(ranked.size(), 3u);
    EXPECT_EQ(ranked[0].in(list).faces, "bad <1>");
    EXPECT_EQ(ranked[1].in(list).faces, "near");
    EXPECT_EQ(ranked[2].in(list).faces, "good");
    EXPECT_EQ(count_crossings(list).not_judged, 1u);
}

TEST(Lines, TableHasRanksAndSignsAndNoMinusZero) {
    LineList list = lines();
    list.views[0].found.crossings[0].jump.value = -1e-9;
    const std::string table = crossings_table(list, 2);
    EXPECT_NE(table.find("\n  1  fail           2.5    0.0000  -0.2500   4.0000"),
              std::string::npos)
        << table;
    EXPECT_EQ(table.find("-0.0000"), std::string::npos) << table;
    EXPECT_NE(table.find("... and 1 crossings less bad\n"), std::string::npos);
}

TEST(ReportVerdict, IsTheWorstOfSeamsAndLines) {
    Report clean;
    EXPECT_EQ(verdict_of(clean), Verdict::pass);
    clean.lines = lines();
    EXPECT_EQ(verdict_of(clean), Verdict::fail);
    const auto json = nlohmann::json::parse(report_json(clean));
    EXPECT_EQ(json["verdict"], "fail");
    EXPECT_EQ(json["counts"]["fail"], 0);
    EXPECT_EQ(json["lines"]["counts"]["fail"], 1);
    EXPECT_EQ(json["lines"]["crossings"].size(), 4u);
    EXPECT_EQ(json["lines"]["crossings"][2]["view"], "top");
    EXPECT_TRUE(nlohmann::json::parse(report_json(report()))["lines"].is_null());
}

TEST(ReportHtml, HasLinesWorstFirstWithTheirLimits) {
    Report with_lines = report();
    EXPECT_EQ(report_html(with_lines).find("Reflection lines"), std::string::npos);
    with_lines.lines = lines();
    const std::string html = report_html(with_lines);
    EXPECT_NE(html.find("rig tubes &amp; more"), std::string::npos);
    EXPECT_NE(html.find("1 crossing fails, 0 undecided, 2 pass, 1 not judged"), std::string::npos);
    EXPECT_LT(html.find("bad &lt;1&gt;"), html.find(">near<"));
    EXPECT_NE(html.find("<b>1</b>line crossing fails"), std::string::npos);
}

TEST(ReportHtml, HasThePlacesWhereLinesTurnOver) {
    Report with_lines = report();
    with_lines.lines = lines();
    EXPECT_EQ(report_html(with_lines).find("turn over"), std::string::npos);
    JoinedLine line;
    line.plane = 1, line.lamp = 7, line.length = 812.34;
    line.inflections = {{100.5, {1, 2, 3}}, {700, {4, 5, 6.25}}};
    with_lines.lines->views[1].found.lines = {line, {}};
    const std::string html = report_html(with_lines);
    EXPECT_NE(html.find("<summary>1 line turns over at 2 places</summary>"), std::string::npos);
    const std::size_t row = html.find(">1.7</td>");
    EXPECT_EQ(html.find("812.3", row), html.find("812.3"));
    EXPECT_NE(html.find(">100.5</td><td data-v=\"1\">1.0, 2.0, 3.0</td>"), std::string::npos);
    EXPECT_NE(html.find(">700.0</td><td data-v=\"4\">4.0, 5.0, 6.3</td>"), std::string::npos);
}

TEST(ReportHtml, TellsBeforeAllElseHowMuchOfTheBordersMeetsNoOther) {
    const std::string html = report_html(report());
    const std::size_t told = html.find("mm of borders meet no other · class-a-outer");
    EXPECT_LT(told, html.find("<div class=\"counts\">"));
    EXPECT_EQ(html.find("no seam was judged"), std::string::npos);
    EXPECT_NE(html.find("<b>1</b>face lost"), std::string::npos);
}

TEST(ReportHtml, WarnsOfABodyWithoutAnySeam) {
    test::ModelBuilder builder;
    builder.plane({0, 0, 0}, {100, 0, 0}, {0, 50, 0});
    builder.plane({0, 50.6, 0}, {100, 0, 0}, {0, 50, 0});
    Report apart;
    apart.inspection = inspect(builder.build());
    const std::string html = report_html(apart);
    EXPECT_NE(html.find("600.0 of 600.0 mm of borders meet no other"), std::string::npos);
    EXPECT_NE(html.find("<b>no seam was judged: of 2 faces no two have borders that run along "
                        "each other within 0.5 mm (--join)</b>"),
              std::string::npos);
}

/// Two sheets that meet along x, the second turned by `degrees` from where the first leads.
std::string html_of_bend(double degrees) {
    const double angle = degrees_to_radians(degrees);
    test::ModelBuilder builder;
    builder.plane({0, 0, 0}, {100, 0, 0}, {0, -50, 0});
    builder.plane({0, 0, 0}, {100, 0, 0}, {0, 50 * std::cos(angle), 50 * std::sin(angle)});
    Report bent;
    bent.inspection = inspect(builder.build());
    return report_html(bent);
}

TEST(ReportHtml, TellsHowFarALampsImageJumpsButNotOverAFold) {
    // 2 D tan 4 degrees, D = 2 m.
    EXPECT_NE(html_of_bend(4).find("279.7 mm at 2 m"), std::string::npos);
    const std::string fold = html_of_bend(179.5);
    EXPECT_NE(fold.find("179.500°"), std::string::npos);
    EXPECT_EQ(fold.find("mm at 2 m"), std::string::npos);
}

TEST(FactsText, FoldsEqualRemarksAndTellsALostFaceOnce) {
    SurfaceModel remarked = model();
    for (int i = 0; i < 3; ++i) {
        remarked.diagnostics.push_back({Severity::warning, "", "a void surface"});
        remarked.diagnostics.push_back({Severity::note, "", "a void surface"});
    }
    const ModelFacts facts = inspect(remarked).facts;
    const std::string text = facts_text(facts);
    EXPECT_NE(text.find("\nnote        face 2: invalid in the file\n"
                        "warning     a void surface (3 times)\n"
                        "note        a void surface (3 times)\n"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("\nlost        face 7 rear: no surface\n"), std::string::npos) << text;
    EXPECT_EQ(text.find("no surface"), text.rfind("no surface"));
    EXPECT_EQ(facts.remarks.errors, 1u);
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
    const auto check = nlohmann::json::parse(inspection_json(inspection, "9.9"));
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
         {"<header class=\"card head fail\">", "seams fail", "undecided", "</b>crease</div>",
          "not covered", "Reflections", "Worst seams", "0.0400 mm", "0.300°", "Coverage", "87.5 %",
          "All seams", "lost faces", "repairs", "1 × open loop closed on 1 face, up to 0.25 mm",
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

TEST(ReportFiles, AreAllOfItAndTheSameBytesAgain) {
    const FolderContent files = report_files(report());
    EXPECT_EQ(files.at("front.png"), "not really a PNG");
    EXPECT_TRUE(files.contains("seam-1.png"));
    EXPECT_EQ(files.at("report.html"), report_html(report()));
    EXPECT_EQ(report_files(report()), files);
}

} // namespace
} // namespace keiko
