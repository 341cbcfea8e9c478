#include "keiko/workflow/analysis_file.h"

#include "keiko/base/error.h"

#include <gtest/gtest.h>

#include <string>

namespace keiko {
namespace {

/// An analysis with all that one can have.
Analysis whole_analysis() {
    Analysis analysis;
    analysis.views.push_back({"shown", {.eye = {0.1, -2000, 1e-7}, .width = 96, .height = 54}});
    analysis.views.push_back({"a_b-2",
                              {.projection = Projection::orthographic,
                               .eye = {0, -1, 0},
                               .target = {0, 0, 0},
                               .orthographic_height = 1.0 / 3},
                              "curvature:k1=0.002"});
    analysis.views.push_back({"cuts", {}, "curvature:section=0.01", Vec3(1, 2, 1.0 / 3)});
    analysis.sections = {"y=120", "1,1,0=-3"};
    analysis.rig.emplace();
    analysis.rig->name = "two \"rows\"";
    analysis.rig->sources.emplace_back(
        CPlane{.origin = {-3000, -2000, 3000}, .u = {6000, 0, 0}, .v = {0, 4000, 0}, .lamps = 10});
    analysis.rig->sources.emplace_back(Spotlight{});
    analysis.hidden = {{2, "dome", Vec3(1, 2, 1.0 / 3)}, {3, "", Vec3(0)}, {4, "side", {}}};
    analysis.notes = {{"one\nand two", {1, 2, 3}, 7}, {"lost", {4, 5, 6}, 0}};
    return analysis;
}

std::string error_of(Analysis analysis) {
    try {
        require_valid(analysis);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

} // namespace

TEST(AnalysisFile, ReadsBackAsTheSame) {
    const Analysis written = whole_analysis();
    const std::string text = analysis_text(written);
    const Analysis read = parse_analysis_alone(text, "a.json");
    EXPECT_EQ(analysis_text(read), text);
    ASSERT_EQ(read.views.size(), 3U);
    EXPECT_EQ(read.views[0].camera, written.views[0].camera);
    EXPECT_EQ(read.views[1].camera, written.views[1].camera);
    EXPECT_EQ(read.views[1].look, "curvature:k1=0.002");
    EXPECT_FALSE(read.views[1].across);
    EXPECT_EQ(read.views[2].across, written.views[2].across);
    EXPECT_EQ(read.sections, written.sections);
    ASSERT_TRUE(read.rig);
    EXPECT_EQ(read.rig->name, written.rig->name);
    EXPECT_EQ(read.rig->sources.size(), 2U);
    ASSERT_EQ(read.hidden.size(), 3U);
    EXPECT_EQ(read.hidden[0].place, written.hidden[0].place);
    EXPECT_FALSE(read.hidden[2].place);
    ASSERT_EQ(read.notes.size(), 2U);
    EXPECT_EQ(read.notes[0].text, "one\nand two");
    EXPECT_EQ(read.notes[1].face, 0U);
}

TEST(AnalysisFile, HoldsNothingButItsFormatIfNeedBe) {
    const Analysis read = parse_analysis_alone("{\"format\": \"keiko-analysis/1\"}", "a.json");
    EXPECT_TRUE(read.views.empty());
    EXPECT_FALSE(read.rig);
}

TEST(AnalysisFile, RefusesWhatNoFileMayHold) {
    EXPECT_EQ(error_of(whole_analysis()), "");
    Analysis analysis = whole_analysis();
    analysis.views[1].name = "shown";
    EXPECT_EQ(error_of(analysis), "views 2, name: \"shown\" is that of view 1, too");
    analysis = whole_analysis();
    analysis.views[2].look = "curvature:mean";
    EXPECT_EQ(error_of(analysis), "views 3, across: is for the look curvature:section");
    analysis = whole_analysis();
    analysis.views[0].across = Vec3(0, 1, 0);
    EXPECT_EQ(error_of(analysis), "views 1, across: is for the look curvature:section");
    analysis = whole_analysis();
    analysis.views[2].across = Vec3(0);
    EXPECT_EQ(error_of(analysis), "views 3, across: is no direction");
    analysis = whole_analysis();
    analysis.notes[1].text.clear();
    EXPECT_EQ(error_of(analysis), "notes 2: needs a text of 1 to 1000 bytes");
}

TEST(AnalysisFile, OfAPageNamesNoFile) {
    const std::string rig = "\"format = 'keiko-rig/1'\", \"[[luminaire]]\", \"file = 'a.ies'\"";
    EXPECT_THROW(parse_analysis_alone("{\"format\": \"keiko-analysis/1\", \"rig\": [" + rig + "]}",
                                      "a.json"),
                 Error);
}

} // namespace keiko
