#include "keiko/report/content/report.h"

#include "tests/unit/report/sample_report.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace keiko {
namespace {

using namespace test;

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

TEST(ReportFiles, AreAllOfItAndTheSameBytesAgain) {
    const FolderContent files = report_files(report());
    EXPECT_EQ(files.at("front.png"), "not really a PNG");
    EXPECT_TRUE(files.contains("seam-1.png"));
    EXPECT_EQ(files.at("report.html"), report_html(report()));
    EXPECT_EQ(report_files(report()), files);
}

} // namespace
} // namespace keiko
