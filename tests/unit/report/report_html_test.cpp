#include "keiko/base/units.h"
#include "keiko/report/content/report.h"
#include "keiko/report/content/triaged_faults.h"
#include "keiko/triage/reflection_break.h"

#include "tests/support/model_builder.h"
#include "tests/unit/report/sample_report.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace keiko {
namespace {

using namespace test;

TEST(ReportHtml, RowsOfFindingsOpenTheirCloseUps) {
    Report with_faces = report();
    ReportPicture dent{"close-up-2", "", "close-up-2.png", "a dent", 360, 240, {}};
    with_faces.close_ups[0].picture.title = "close-up-1";
    with_faces.close_ups.push_back({CloseUp::Of::face, 1, dent, {}});
    const std::string html = report_html(with_faces);
    EXPECT_NE(html.find("data-shot=\"close-up-1\""), std::string::npos);
    EXPECT_NE(html.find("data-shot=\"close-up-2\""), std::string::npos);
    EXPECT_NE(html.find("<img id=\"close-up-1\""), std::string::npos);
    // The seam's is in its card, the face's in the gallery.
    EXPECT_LT(html.find("<img id=\"close-up-1\""), html.find("<div hidden>"));
    EXPECT_GT(html.find("<img id=\"close-up-2\""), html.find("<div hidden>"));
    EXPECT_NE(html.find("<dialog id=\"viewer\">"), std::string::npos);
    const auto json = nlohmann::json::parse(report_json(with_faces));
    EXPECT_EQ(json["close_ups"][1]["face"], 2);
}

TEST(ReportHtml, TheDrawingIsTheFirstPictureBesideTheStripesAndLeadsToTheFindings) {
    Report drawn = report();
    EXPECT_EQ(report_html(drawn).find("class=\"card drawn\""), std::string::npos);
    drawn.drawing = "<svg class=\"drawing\"><a href=\"#finding-1\"></a></svg>";
    const std::string html = report_html(drawn);
    const std::size_t heading = html.find("<h2>Reflections</h2>"), at = html.find(drawn.drawing);
    ASSERT_NE(at, std::string::npos);
    EXPECT_LT(heading, at);
    EXPECT_LT(at, html.find("<img", heading));
    EXPECT_NE(html.find("<tr id=\"finding-1\""), std::string::npos);
}

TEST(ReportHtml, ASentenceStandsWhereTheDrawingWouldBe) {
    Report large = report();
    large.drawing = "No line drawing: too many <faces>.";
    const std::string html = report_html(large);
    const std::size_t heading = html.find("<h2>Reflections</h2>");
    const std::size_t at = html.find("No line drawing: too many &lt;faces&gt;.");
    ASSERT_NE(at, std::string::npos);
    EXPECT_LT(heading, at);
    EXPECT_LT(at, html.find("<img", heading));
}

TEST(ReportHtml, NotesStandWithTheirPlaces) {
    Report noted = report();
    EXPECT_EQ(report_html(noted).find(">Notes<"), std::string::npos);
    EXPECT_TRUE(nlohmann::json::parse(report_json(noted))["notes"].empty());
    const std::uint32_t id = noted.inspection.faces[1].id;
    noted.notes = {{"mind <this>", {1, 2.5, 3}, id}, {"gone", {4, 5, 6}, 0}};
    const std::string html = report_html(noted);
    EXPECT_NE(html.find("<h2>Notes</h2>"), std::string::npos);
    EXPECT_NE(html.find("mind &lt;this&gt;"), std::string::npos);
    EXPECT_NE(html.find("(A&amp;B) at 1.0, 2.5, 3.0 mm"), std::string::npos);
    EXPECT_NE(html.find("no place on this body any more; it was at 4.0, 5.0, 6.0 mm"),
              std::string::npos);
    const auto notes = nlohmann::json::parse(report_json(noted))["notes"];
    EXPECT_EQ(notes[0],
              (nlohmann::json{{"text", "mind <this>"}, {"place", {1, 2.5, 3}}, {"face", id}}));
    EXPECT_TRUE(notes[1]["face"].is_null());
}

TEST(ReportHtml, PlotsTheProfilesOfStretchesThatDoNotPass) {
    Report plotted = report();
    EXPECT_EQ(report_html(plotted).find("<svg class=\"profile\""), std::string::npos);
    const Inspection& found = plotted.inspection;
    const SurfaceModel body = model();
    const std::vector<std::uint32_t> of_worst = worst_seams(found, 1);
    plotted.profiles = seam_profiles(body, found.seams, found.pieces, of_worst, found.preset);
    const std::string html = report_html(plotted);
    const auto at = html.find("<svg class=\"profile\"");
    ASSERT_NE(at, std::string::npos);
    EXPECT_GT(at, html.find("Worst stretches of seams"));
    EXPECT_EQ(html.find("Profiles of further stretches"), std::string::npos);
    // One that has no card among the worst: a crease.
    const std::vector<std::uint32_t> other{2};
    plotted.profiles = seam_profiles(body, found.seams, found.pieces, other, found.preset);
    EXPECT_NE(report_html(plotted).find("Profiles of further stretches"), std::string::npos);
}

TEST(ReportHtml, ListsScrapsApartFromOtherStretches) {
    Report scrapped = report();
    EXPECT_EQ(report_html(scrapped).find("<h2>Scraps</h2>"), std::string::npos);
    MeasuredSeam& scrap = scrapped.inspection.seams[2];
    scrap.scrap = true, scrap.faces = "the scrap";
    const std::string html = report_html(scrapped);
    const auto apart = html.find("<h2>Scraps</h2>"), all = html.find("All stretches of seams");
    ASSERT_NE(apart, std::string::npos);
    ASSERT_LT(all, apart);
    EXPECT_EQ(html.substr(all, apart - all).find("the scrap"), std::string::npos);
    EXPECT_NE(html.find("the scrap", apart), std::string::npos);
}

TEST(ReportHtml, ListsJointsWithTheirVerdicts) {
    Report joined = report();
    EXPECT_EQ(report_html(joined).find("<h2>Joints</h2>"), std::string::npos);
    Joint joint;
    joint.names = "face 1 | face 9", joint.length = 123.45, joint.stations.resize(1);
    JointSection narrow, wide;
    narrow.gap = 3.25, wide.gap = 4.5;
    joint.extremes = {wide, narrow, narrow, wide, narrow};
    joined.inspection.joints = {joint};
    const auto row = [&] {
        const std::string html = report_html(joined);
        return html.substr(html.find("<h2>Joints</h2>"), 2000);
    };
    EXPECT_NE(row().find("<span class=\"chip\">fail</span>"), std::string::npos) << "parallelism";
    EXPECT_NE(row().find("3.250 to 4.500"), std::string::npos);
    joined.inspection.preset.joint = {.gap = NominalSize{4, 0.6}};
    EXPECT_NE(row().find("fail"), std::string::npos);
    joined.inspection.preset.joint.gap->tolerance = 0.8;
    EXPECT_NE(row().find("<span class=\"chip\">pass</span>"), std::string::npos);
    EXPECT_NE(row().find("gap mm, 4 ± 0.8 mm"), std::string::npos);
    joined.inspection.preset.joint = {};
    EXPECT_NE(row().find("not judged"), std::string::npos);
}

TEST(ReportHtml, EscapesTheNamesInMessagesThatRowsAreSortedBy) {
    Report with_look = report();
    Check strip;
    strip.message = "across it face 1 (\"a\" <b>) turns";
    with_look.inspection.looks = {strip};
    const std::string html = report_html(with_look);
    EXPECT_NE(html.find("data-v=\"across it face 1 (&quot;a&quot; &lt;b&gt;) turns\""),
              std::string::npos);
    EXPECT_EQ(html.find("(\"a\""), std::string::npos);
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
                        "each other within the join distance, 0.5 mm</b>"),
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

TEST(ReportHtml, ListsHowACreaseFades) {
    Report fading = report();
    fading.inspection.preset.fading = 0.0014;
    MeasuredSeam& crease = fading.inspection.seams[0];
    crease.kind = SeamClass::crease;
    crease.fading = {.value = 0.05, .bound = 0, .limit = 0.0014, .verdict = Verdict::fail};
    fading.inspection.counts.run_outs = 3;
    const std::string html = report_html(fading);
    EXPECT_NE(html.find(">fading °/mm ≤ 0.0014<"), std::string::npos);
    EXPECT_NE(html.find("<td class=\"tone\" data-v=\"0.05\">0.05</td>"), std::string::npos);
    EXPECT_NE(html.find("3</b>run-outs</a>"), std::string::npos);
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
    for (const char* absent :
         {"Reflections", "Worst stretches of seams", "Coverage", "not covered"})
        EXPECT_EQ(html.find(absent), std::string::npos) << absent;
    EXPECT_NE(html.find("<header class=\"card head pass\">"), std::string::npos);
}

} // namespace
} // namespace keiko
