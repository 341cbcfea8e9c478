#include "keiko/report/content/acceptance_texts.h"

#include "keiko/base/error.h"
#include "keiko/report/content/inspection_texts.h"

#include "tests/unit/report/sample_report.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace keiko {
namespace {

using nlohmann::json;

const AcceptanceNote note{"Ann", "hidden <by> the trim", "2026-11-27", "2027-01-31"};

/// One of a seam, and one of lines without a bound.
std::vector<Acceptance> entries() {
    Acceptance seam;
    seam.code = "G-SU-LG", seam.faces = "face 1 | face 2", seam.unit = "mm";
    seam.place = {1, 2, 3.5}, seam.reach = 5, seam.stretch = {Vec3(4, 5, 6), 100};
    seam.value = 0.05, seam.bound = 1e-9, seam.limit = 0.01, seam.verdict = Verdict::fail;
    seam.note = note;
    Acceptance lines = seam;
    lines.code = "KEIKO-LINE-TURN", lines.view = "front", lines.formula = "alias";
    lines.stretch.reset(), lines.note.until.clear(), lines.verdict = Verdict::undecided;
    lines.bound = std::numeric_limits<double>::infinity();
    return {seam, lines};
}

/// The error of a file in which `change` was made to the JSON of entries().
template <class Change>
std::string error_of(const Change& change) {
    json file = json::parse(acceptances_json(entries()));
    change(file);
    try {
        acceptances_from_json(file.dump(), "a.json");
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(AcceptanceFile, ReadsWhatItWrites) {
    const std::string text = acceptances_json(entries());
    const std::vector<Acceptance> read = acceptances_from_json(text, "a.json");
    ASSERT_EQ(read.size(), 2u);
    EXPECT_EQ(acceptances_json(read), text);
    EXPECT_EQ(read[0].stretch->middle, Vec3(4, 5, 6));
    EXPECT_EQ(read[0].note.until, "2027-01-31");
    EXPECT_EQ(read[1].bound, std::numeric_limits<double>::infinity());
    EXPECT_EQ(read[1].view, "front");
    EXPECT_FALSE(read[1].stretch);
}

TEST(AcceptanceFile, NamesTheEntryAndTheReason) {
    const auto of_second = [](const char* key, const json& value) {
        return error_of([&](json& file) { file["accepted"][1][key] = value; });
    };
    EXPECT_EQ(of_second("code", "G-SU"), "a.json:entry 2, code: there is no criterion \"G-SU\"");
    EXPECT_EQ(of_second("until", "2026-02-30"),
              "a.json:entry 2, until: \"2026-02-30\" is no date as 2026-11-27");
    EXPECT_EQ(of_second("why", ""), "a.json:entry 2, why: is empty");
    EXPECT_EQ(of_second("reach", 1e9), "a.json:entry 2, reach: is not above 0 and at most 1000 mm");
    EXPECT_EQ(of_second("value", -1), "a.json:entry 2, value: is not a number from 0 on");
    EXPECT_EQ(of_second("verdict", "pass"),
              "a.json:entry 2, verdict: is neither fail nor undecided");
    EXPECT_EQ(of_second("whom", "Ann"), "a.json:entry 2: unknown key \"whom\"");
    EXPECT_EQ(of_second("place", "here"), "a.json:entry 2, place: is no place [x, y, z]");
    EXPECT_EQ(error_of([](json& file) { file["accepted"][0].erase("who"); }),
              "a.json:entry 1, who: is missing");
    EXPECT_EQ(error_of([](json& file) { file["accepted"][0].erase("value"); }),
              "a.json:entry 1: a key is missing or not of the right kind");
    EXPECT_EQ(error_of([](json& file) { file["accepted"].push_back(file["accepted"][0]); }),
              "a.json:entry 3: accepts what entry 1 does");
    EXPECT_EQ(error_of([](json& file) { file["format"] = "keiko-accepted/2"; }),
              "a.json: is not of the format keiko-accepted/1");
    EXPECT_THROW(acceptances_from_json("[", "a.json"), Error);
}

TEST(AcceptanceFile, TakesFindingsOfAReport) {
    const Inspection found = inspect(test::model());
    const std::string report = inspection_json(found, "1");
    const std::vector<std::size_t> items{2, 1};
    const std::vector<Acceptance> read = acceptances_of_report(report, "r.json", {items, {}}, note);
    ASSERT_EQ(read.size(), 2u);
    for (const std::size_t i : {0, 1}) {
        const Acceptance whole = acceptance_of(found.findings.at(items[i] - 1), found.seams, note);
        EXPECT_EQ(acceptances_json({&read[i], 1}), acceptances_json({&whole, 1}));
    }
    const std::vector<std::size_t> beyond{99};
    EXPECT_THROW(acceptances_of_report(report, "r.json", {beyond, {}}, note), Error);
    EXPECT_THROW(acceptances_of_report("{}", "r.json", {items, {}}, note), Error);
}

TEST(Dates, AreDaysOfTheCalendar) {
    for (const char* good : {"2026-11-27", "2028-02-29"}) EXPECT_TRUE(is_date(good)) << good;
    for (const char* bad : {"", "2026-02-29", "2026-13-01", "2026-00-10", "26-11-27", "2026-11-2x",
                            "2026-11-27T", "2026/11/27", "-026-11-27"})
        EXPECT_FALSE(is_date(bad)) << bad;
}

/// The sample with its first finding accepted, and an acceptance that covers nothing.
Inspection accepted() {
    Inspection found = inspect(test::model());
    AcceptanceList list{{acceptance_of(found.findings.at(0), found.seams, note)}, "2026-12-24"};
    list.entries.push_back(list.entries[0]);
    list.entries[1].place += Vec3(0, 0, 500);
    accept_findings(found, list);
    return found;
}

constexpr const char* covers_nothing = "covers nothing any more: no such finding is within 5 mm";

TEST(Accepted, HasAPartOfItsOwnInJson) {
    const Inspection found = accepted();
    const json report = json::parse(inspection_json(found, "1"));
    EXPECT_EQ(report["findings"].size(), found.findings.size());
    ASSERT_EQ(report["accepted"].size(), 1u);
    EXPECT_EQ(report["accepted"][0]["accepted"]["who"], "Ann");
    EXPECT_EQ(report["counts"]["accepted"], 1);
    EXPECT_NE(report["acceptance_remarks"][0].get<std::string>().find(covers_nothing),
              std::string::npos);
}

TEST(Accepted, IsSkippedInJunit) {
    const std::string xml = junit_xml(accepted());
    EXPECT_NE(xml.find("<skipped message=\"accepted: hidden &lt;by&gt; the trim (Ann, 2026-11-27, "
                       "until 2027-01-31); the "),
              std::string::npos)
        << xml;
    EXPECT_NE(xml.find(covers_nothing), std::string::npos);
}

TEST(Accepted, IsSuppressedInSarif) {
    const std::vector<std::filesystem::path> files{"a.step"};
    const auto results = [&](const Inspection& found) {
        return json::parse(sarif_json(found, "1", files))["runs"][0]["results"];
    };
    std::size_t suppressed = 0;
    for (const json& result : results(accepted())) {
        ASSERT_TRUE(result.contains("suppressions"));
        for (const json& one : result["suppressions"]) {
            ++suppressed;
            EXPECT_EQ(one["status"], "accepted");
            EXPECT_EQ(one["justification"],
                      "hidden <by> the trim (Ann, 2026-11-27, until 2027-01-31)");
        }
    }
    EXPECT_EQ(suppressed, 1u);
    for (const json& result : results(inspect(test::model())))
        EXPECT_FALSE(result.contains("suppressions"));
}

TEST(Accepted, IsListedInTextCsvAndHtml) {
    const std::string text = inspection_text(accepted());
    EXPECT_NE(text.find("\n1 accepted, no part of the verdict:\naccepted  G-SU-"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find(", 1 accepted; "), std::string::npos) << text;
    EXPECT_NE(checks_csv(accepted()).find(",accepted,0."), std::string::npos);
    Report report = test::report();
    report.inspection = accepted();
    const std::string html = report_html(report);
    EXPECT_NE(html.find("<h2>Accepted</h2>"), std::string::npos);
    EXPECT_NE(html.find("hidden &lt;by&gt; the trim"), std::string::npos);
    EXPECT_NE(html.find(covers_nothing), std::string::npos);
    EXPECT_EQ(report_html(test::report()).find("<h2>Accepted</h2>"), std::string::npos);
}

/// Lines of one view whose only finding is accepted.
TEST(Accepted, HoldsForLinesOfItsView) {
    LineList list = test::lines();
    std::vector<Check> checks = line_checks(list);
    const auto bad = std::find_if(checks.begin(), checks.end(),
                                  [](const Check& check) { return check.is_finding(); });
    ASSERT_NE(bad, checks.end());
    list.acceptances = {{acceptance_of(*bad, {}, note)}, "2026-12-24"};
    EXPECT_EQ(verdict_of(list), Verdict::pass);
    const Inspection whole = with_lines(inspect(SurfaceModel{}), list);
    EXPECT_EQ(whole.verdict, Verdict::pass);
    EXPECT_EQ(whole.accepted.size(), 1u);
    list.acceptances.today = "2028-01-01";
    EXPECT_EQ(verdict_of(list), Verdict::fail);
    EXPECT_EQ(with_lines(inspect(SurfaceModel{}), list).acceptance_remarks.size(), 1u);
    list.acceptances.today = "2026-12-24", list.acceptances.entries[0].view = "front";
    EXPECT_EQ(verdict_of(list), Verdict::fail);
}

} // namespace
} // namespace keiko
