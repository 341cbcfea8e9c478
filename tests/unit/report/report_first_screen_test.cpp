// The first screen of a report: the verdict, and the faults to mend first.
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

/// The first screen of a report with one fault.
std::string first_screen(Report report, const TriageItem& fault) {
    report.triage = {{fault}, {}};
    const std::string html = report_html(report);
    const auto first = html.find("What to mend first");
    return html.substr(first, html.find("</section>", first) - first);
}

TEST(ReportHtml, TheFirstScreenBeginsWithTheStandingViews) {
    Report with_fault = report();
    ReportPicture standing = with_fault.pictures[0];
    standing.title = "standing-left, faults", standing.file_name = "standing-left-faults.png";
    with_fault.standing_pictures.push_back(standing);
    TriageItem fault;
    fault.mending = Mending::curvature, fault.seams = {0}, fault.findings = {0}, fault.fine = true;
    fault.width = 0.4;
    fault.place = with_fault.inspection.facts.bounds.upper;
    const std::string screen = first_screen(with_fault, fault);
    const auto picture = screen.find("standing-left, faults"), card = screen.find("class=\"name\"");
    ASSERT_NE(card, std::string::npos);
    EXPECT_LT(picture, card);
    EXPECT_NE(screen.find("Tangent only (G2), too fine for an eye · rear right, high · seam 1"),
              std::string::npos);
    EXPECT_NE(screen.find("at most 0.4′ (arc minutes), less than an eye resolves"),
              std::string::npos);
    EXPECT_EQ(report_files(with_fault).count("standing-left-faults.png"), 1u);
    const auto json = nlohmann::json::parse(report_json(with_fault));
    EXPECT_EQ(json["standing_pictures"][0]["markers"].size(), 1u);
}

TEST(ReportHtml, TheOtherFaultsAreNumberedOn) {
    Report crowded = report();
    TriageItem fault;
    fault.seams = {0}, fault.findings = {0};
    crowded.triage.items.assign(9, fault);
    const std::vector<ShownItem> shown = shown_items(crowded);
    ASSERT_EQ(shown.size(), most_shown);
    EXPECT_EQ(shown.back().fault, &crowded.triage.items[6]);
    const std::string html = report_html(crowded);
    const auto others = html.find("What comes after them");
    ASSERT_NE(others, std::string::npos);
    const std::string table = html.substr(others, html.find("</section>", others) - others);
    EXPECT_NE(table.find("<td data-v=\"8\""), std::string::npos) << table;
    EXPECT_NE(table.find("<td data-v=\"9\""), std::string::npos);
    EXPECT_EQ(table.find("<td data-v=\"10\""), std::string::npos);
}

TEST(ReportHtml, AHoleStandsWithWhatLiesBesideIt) {
    Report holed = report();
    Check hole;
    hole.code = "KEIKO-OPENING", hole.faces = "face 8 | face 9", hole.message = "a hole of 13 mm";
    hole.severity = Check::Severity::look, hole.opening_length = 20, hole.face = 0;
    hole.worst.verdict = Verdict::fail;
    holed.inspection.looks.push_back(hole);
    TriageItem fault;
    fault.mending = Mending::position, fault.face = 0, fault.seams = {0};
    fault.findings = {holed.inspection.findings.size(), 0};
    fault.width = lamp_width;
    const std::string screen = first_screen(holed, fault);
    EXPECT_NE(screen.find("counts as a whole stripe torn away"), std::string::npos);
    const auto name = screen.find("face 8 | face 9"),
               message = screen.find("no surface between free edges");
    const auto also = screen.find("also face");
    EXPECT_LT(name, message);
    EXPECT_LT(message, also);
    EXPECT_NE(screen.find(": gap of 0.04 mm", also), std::string::npos);
    EXPECT_NE(screen.find("Hole · "), std::string::npos);
    EXPECT_EQ(screen.find("KEIKO-OPENING"), std::string::npos) << "not told again as a look";
    const auto json = nlohmann::json::parse(
        faults_json({{{fault}, {}}, {}}, holed.inspection, "9.9"))["items"][0];
    EXPECT_EQ(json["message"], "a hole of 13 mm");
    EXPECT_EQ(json["findings"][0], holed.inspection.findings.size() + 1);
}

TEST(ReportHtml, RadiiAreThoseWhereTheBreakIsSeen) {
    Report curved = report();
    MeasuredSeam& seam = curved.inspection.seams[0];
    seam.curvature = CurvatureStep{};
    seam.curvature->mismatch = 1;
    seam.curvature->curvature_a = 1 / 27600.0, seam.curvature->curvature_b = 1 / 8000.0;
    TriageItem fault;
    fault.findings = {0}, fault.seams = {0}, fault.place = {10, 0, 0};
    EXPECT_NE(first_screen(curved, fault).find("R 27.6 m | R 8000 mm"), std::string::npos);
    SeamProfile profile;
    for (const double x : {0.0, 9.0, 20.0}) {
        ProfileSample sample;
        sample.point.place = {x, 0, 0};
        sample.point.curvature_a = 1e-7, sample.point.curvature_b = x == 9 ? -1 / 50.0 : 0;
        profile.samples.push_back(sample);
    }
    curved.profiles.push_back(profile);
    EXPECT_NE(first_screen(curved, fault).find("flat | R -50 mm"), std::string::npos);
}

TEST(ReportHtml, BeginsWithTheFaultsToMendFirst) {
    Report triaged = report();
    TriageItem seen, hidden;
    seen.mending = Mending::tangent, seen.findings = {1}, seen.seams = {1};
    seen.length = 100, seen.visible = 0.96, seen.width = 36, seen.weight = 3e4;
    seen.view = "standing-three-quarter-front-left", seen.mirrored = seen.torn = true;
    hidden.mending = Mending::position, hidden.findings = {0}, hidden.seams = {0};
    hidden.length = 100, hidden.view = "top";
    triaged.triage = {{seen}, {hidden}};
    const std::string html = report_html(triaged);
    const auto first = html.find("What to mend first"), apart = html.find("hidden places");
    ASSERT_NE(first, std::string::npos);
    ASSERT_LT(first, apart);
    const std::string screen = html.substr(first, apart - first);
    EXPECT_NE(screen.find("mend the tangent · tears a stripe by up to 36′ (arc minutes), seen from "
                          "three-quarter front left "
                          "· 100.0 mm on 1 seam, 96 % of it visible · on both sides · weight "
                          "30000′"),
              std::string::npos);
    EXPECT_NE(screen.find("0.300°"), std::string::npos);
    EXPECT_EQ(screen.find("0.0400 mm"), std::string::npos) << "the gap is hidden";
    EXPECT_NE(html.find("Gap (G0)", apart), std::string::npos);
    const auto json = nlohmann::json::parse(report_json(triaged))["triage"];
    EXPECT_EQ(json["items"][0]["findings"], nlohmann::json({2}));
    EXPECT_EQ(json["items"][0]["seams"], nlohmann::json({2}));
    EXPECT_EQ(json["hidden"][0]["mending"], "position");
    ASSERT_EQ(shown_items(triaged).size(), 1u);
    EXPECT_EQ(shown_items(report()).size(), 2u) << "else the worst stretches";
}

TEST(ReportHtml, AFaultOfAFaceHasACard) {
    Report triaged = report();
    Check dent;
    dent.code = "KEIKO-DENT", dent.unit = "mm", dent.face = 2, dent.faces = "face 3";
    dent.message = "the dent of 0.1 mm is over the limit", dent.worst.verdict = Verdict::fail;
    triaged.inspection.findings.push_back(dent);
    TriageItem fault;
    fault.mending = Mending::curvature, fault.findings = {2}, fault.face = 2;
    fault.length = 10, fault.visible = 1, fault.width = 5, fault.weight = 100, fault.view = "top";
    triaged.triage.items = {fault};
    const std::string html = report_html(triaged);
    const auto first = html.find("What to mend first");
    const std::string_view sight =
        "width by up to 5.0′ (arc minutes), seen from top · weight 100′</div>";
    const auto told = html.find(sight);
    ASSERT_NE(told, std::string::npos);
    EXPECT_LT(first, told);
    EXPECT_LT(told, html.find("the dent of 0.1 mm", told));
    EXPECT_NE(html.find("the dent of 0.1 mm", told), std::string::npos);
}

TEST(ReportHtml, TellsTheFirstScreenInOrder) {
    const std::string html = report_html(report());
    std::size_t at = 0;
    for (const char* text :
         {"<header class=\"card head fail\">", "stretches fail", "undecided", "</b>crease</a>",
          "not covered", "Worst stretches of seams", "0.0400 mm", "0.300°", "Reflections",
          "Coverage", "87.5 %", "All stretches of seams", "lost faces", "repairs",
          "1 × open loop closed on 1 face, up to 0.25 mm", "a &lt;seam&gt; added",
          "invalid in the file"}) {
        const std::size_t next = html.find(text, at);
        ASSERT_NE(next, std::string::npos) << text;
        at = next;
    }
}

} // namespace
} // namespace keiko
