#include "keiko/report/content/inspection_texts.h"
#include "keiko/report/content/report.h"

#include "tests/unit/report/sample_report.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>

namespace keiko {
namespace {

using namespace test;

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
    EXPECT_EQ(json["seams"][2]["kind"], "crease");
    EXPECT_EQ(json["findings"][0]["code"], "G-SU-LG");
    EXPECT_EQ(json["findings"][1]["quantity"], "angle");
    EXPECT_EQ(json["worst_seams"], nlohmann::json({1, 2}));
    EXPECT_EQ(json["coverage"]["covered"], 0.875);
    EXPECT_EQ(json["pictures"][0]["markers"][0]["number"], 1);
    EXPECT_EQ(json["close_ups"][0]["seam"], 1);
    EXPECT_EQ(json["model"]["lost_faces"][0]["id"], 7);
    EXPECT_EQ(json["model"]["degrees"][0]["patches"], 4);
}

TEST(ReportJson, NamesItsInputsAndViews) {
    Report seen = report();
    seen.inputs = {{"door.step", std::string(64, 'a')}};
    seen.views.push_back({"front", {}});
    seen.views[0].camera.eye = {1, 2, 3};
    const auto json = nlohmann::json::parse(report_json(seen));
    ASSERT_EQ(json["inputs"].size(), 1u);
    EXPECT_EQ(json["inputs"][0]["path"], "door.step");
    EXPECT_EQ(json["inputs"][0]["sha256"], seen.inputs[0].sha256);
    ASSERT_EQ(json["views"].size(), 1u);
    EXPECT_EQ(json["views"][0]["name"], "front");
    EXPECT_EQ(json["views"][0]["camera"]["eye"], nlohmann::json({1, 2, 3}));
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
    traced.inspection.facts.tracing = trace_facts(
        {.sub_patches = 9, .sub_patches_mixed = 2, .bytes = 1 << 20, .build_seconds = 3});
    const auto tracing = nlohmann::json::parse(report_json(traced))["model"]["tracing"];
    EXPECT_EQ(tracing["sub_patches"], 9);
    EXPECT_EQ(tracing["mixed_sub_patches"], 2);
    EXPECT_FALSE(tracing.contains("build_milliseconds"));
    EXPECT_NE(report_html(traced).find("9 sub-patches, 2 cut by trims, 1.00 MiB"),
              std::string::npos);
}

} // namespace
} // namespace keiko
