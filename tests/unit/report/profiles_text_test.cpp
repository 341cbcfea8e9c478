#include "keiko/report/content/profiles_text.h"

#include "tests/unit/report/sample_report.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <numeric>
#include <sstream>

namespace keiko {
namespace {

class ProfilesText : public testing::Test {
protected:
    ProfilesText() : body(test::model()), inspection(inspect(body)) {
        std::vector<std::uint32_t> all(inspection.seams.size());
        std::iota(all.begin(), all.end(), 0u);
        profiles = seam_profiles(body, inspection.seams, inspection.pieces, all, {});
    }

    std::string svg(const SeamProfile& profile) const {
        return profile_svg(profile, CurvatureFormula::alias);
    }

    SurfaceModel body;
    Inspection inspection;
    std::vector<SeamProfile> profiles;
};

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

/// A gap of 0.04 mm, an angle of 0.3 degrees and a crease of 39.7 degrees.
TEST_F(ProfilesText, JsonHasLimitsSharesAndSamplesOfEveryStretch) {
    const auto json = nlohmann::json::parse(profiles_json(profiles, inspection, "9.9"));
    EXPECT_EQ(json["format"], "keiko-profiles/1");
    EXPECT_EQ(json["preset"], "class-a-outer");
    ASSERT_EQ(json["profiles"].size(), 3u);
    const auto& gap = json["profiles"][0]["gap"];
    EXPECT_NEAR(gap["largest"].get<double>(), 0.04, 1e-9);
    EXPECT_EQ(gap["limit"], 0.01);
    EXPECT_NEAR(gap["beyond"]["share"].get<double>(), 1, 1e-12);
    const auto& bent = json["profiles"][1];
    EXPECT_NEAR(bent["angle"]["largest"].get<double>(), 0.3, 1e-9);
    EXPECT_EQ(bent["gap"]["beyond"]["share"], 0);
    EXPECT_EQ(bent["curvature"]["judged"], false);
    EXPECT_EQ(bent["curvature"]["formula"], "alias");
    const auto& crease = json["profiles"][2];
    EXPECT_EQ(crease["kind"], "crease");
    EXPECT_TRUE(crease["angle"]["limit"].is_null());
    EXPECT_TRUE(crease["angle"]["beyond"].is_null());
    EXPECT_EQ(crease["curvature_slope"], nullptr);
    for (const auto& sample : crease["samples"])
        EXPECT_NEAR(sample["angle"].get<double>(), 39.7, 1e-9);
}

TEST_F(ProfilesText, CsvHasARowASampleWithAllColumns) {
    std::size_t samples = 0;
    for (const SeamProfile& profile : profiles) samples += profile.samples.size();
    std::istringstream lines(profiles_csv(profiles, inspection));
    std::string header, line;
    std::getline(lines, header);
    const auto commas = std::count(header.begin(), header.end(), ',');
    std::size_t rows = 0;
    for (; std::getline(lines, line); ++rows)
        EXPECT_EQ(std::count(line.begin(), line.end(), ','), commas) << line;
    EXPECT_EQ(rows, samples);
}

/// A sample without normals has empty fields, not zeros.
TEST_F(ProfilesText, LeavesOutWhatASampleDoesNotHave) {
    for (ProfileSample& sample : profiles[0].samples)
        sample.point.angle.reset(), sample.mismatch.reset(), sample.slope.reset();
    const std::string csv = profiles_csv(std::span(profiles).first(1), inspection);
    // From the angle to the change of the slope: eight empty fields.
    EXPECT_EQ(count(csv, ",,,,,,,,,"), profiles[0].samples.size());
    const auto json = nlohmann::json::parse(profiles_json(profiles, inspection, "9.9"));
    const auto& sample = json["profiles"][0]["samples"][0];
    EXPECT_TRUE(sample["angle"].is_null());
    EXPECT_FALSE(sample.contains("curvatures"));
}

TEST_F(ProfilesText, PlotsShadeWhatIsBeyondALimit) {
    const std::string gap = svg(profiles[0]), crease = svg(profiles[2]);
    EXPECT_EQ(count(gap, "class=\"beyond\""), 1u);
    EXPECT_NE(gap.find("largest 0.04 mm · limit 0.01 mm · 100.0 % of the length beyond"),
              std::string::npos);
    EXPECT_EQ(count(crease, "class=\"beyond\""), 0u);
    EXPECT_NE(crease.find("largest 39.7° · no limit here"), std::string::npos);
    EXPECT_EQ(count(gap, "<svg"), count(gap, "</svg>"));
}

TEST_F(ProfilesText, PlotsHaveCurvaturesWhereTheAngleFails) {
    const std::string text = svg(profiles[1]);
    EXPECT_NE(text.find("class=\"value a\""), std::string::npos);
    EXPECT_NE(text.find("class=\"value b\""), std::string::npos);
    EXPECT_NE(text.find("limit 10 % · 0.0 % of the length beyond · not judged"), std::string::npos);
}

TEST_F(ProfilesText, PlotsShadeRunsApartAndToTheCrossing) {
    SeamProfile profile = profiles[0];
    profile.samples.clear(), profile.length = 100;
    const std::vector<double> gaps{0, 0.02, 0, 0, 0.02, 0.02};
    for (std::size_t i = 0; i < gaps.size(); ++i) {
        ProfileSample sample;
        sample.along = 20 * static_cast<double>(i), sample.point.gap = gaps[i];
        profile.samples.push_back(sample);
    }
    const std::string text = svg(profile);
    EXPECT_EQ(count(text, "class=\"beyond\""), 2u);
    // 68 to 748 units are 0 to 100 mm: 10 to 30 mm, and 70 mm to the end.
    EXPECT_NE(text.find("class=\"beyond\" x=\"136\" y=\"18\" width=\"136\""), std::string::npos);
    EXPECT_NE(text.find("class=\"beyond\" x=\"544\" y=\"18\" width=\"204\""), std::string::npos);
}

} // namespace
} // namespace keiko
