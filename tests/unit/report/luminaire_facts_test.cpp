#include "keiko/report/content/luminaire_facts.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>
#include <vector>

namespace keiko {
namespace {

/// Lambert's cosine, 100 cd on the axis: 100 pi lm.
PhotometricWeb lambert() {
    std::vector<double> angles, candela;
    for (int v = 0; v <= 90; ++v) {
        angles.push_back(v);
        candela.push_back(100 * std::cos(v * std::numbers::pi / 180));
    }
    return {.type = PhotometricType::c,
            .candela = {angles, {0}, candela, PlaneSymmetry::axial},
            .name = "a <lamp>",
            .lamp_flux = 500};
}

} // namespace

TEST(LuminaireFacts, TellFluxAndSpread) {
    const LuminaireFacts facts = luminaire_facts("lambert.ies", lambert());
    EXPECT_NEAR(facts.flux, 100 * std::numbers::pi, 0.02);
    const auto json = nlohmann::json::parse(luminaire_json(facts));
    EXPECT_EQ(json["format"], "keiko-luminaire-facts/1");
    EXPECT_EQ(json["luminous_flux"], facts.flux);
    EXPECT_EQ(json["light_output_ratio"], facts.flux / 500);
    EXPECT_EQ(json["largest_intensity"]["candela"], 100);
    EXPECT_NEAR(json["beam_angle"]["plane_90"].get<double>(), 120, 1e-3);
    EXPECT_NEAR(json["field_angle"]["plane_0"].get<double>(), 168.52, 0.01);
    EXPECT_EQ(json["symmetry"], "axial");
    const std::string text = luminaire_text(facts);
    EXPECT_NE(text.find("type        C, symmetry axial\n"), std::string::npos) << text;
    EXPECT_NE(text.find("beam angle  C0-C180: 120 degrees\n            C90-C270: 120 degrees\n"),
              std::string::npos)
        << text;
    EXPECT_EQ(json["diagnostics"], nlohmann::json::array());
}

/// Towards C0 the table ends above the limit; C90 and C270 are lit on one side alone.
TEST(LuminaireFacts, HaveTwoHalfAnglesWhereThereIsNoFullOne) {
    const PhotometricWeb web{.type = PhotometricType::c,
                             .candela = {{0, 30, 60, 90},
                                         {0, 90, 180, 270},
                                         {0, 4, 8, 8, 0, 8, 0, 0, 0, 4, 0, 0, 0, 0, 0, 0},
                                         PlaneSymmetry::none}};
    const LuminaireFacts facts = luminaire_facts("wall.ldt", web);
    const std::string text = luminaire_text(facts);
    EXPECT_NE(text.find("beam angle  C0-C180: not reached within 90 degrees towards C0, 30 degrees "
                        "towards C180\n            C90-C270: 30 degrees: from 15 to 45 degrees "
                        "towards C90\n"),
              std::string::npos)
        << text;
    const auto json = nlohmann::json::parse(luminaire_json(facts));
    EXPECT_TRUE(json["beam_angle"]["plane_0"].is_null());
    EXPECT_EQ(json["beam_edges"]["plane_0"]["positive"],
              (nlohmann::json{{"degrees", 90}, {"reached", false}}));
    EXPECT_EQ(json["beam_edges"]["plane_90"]["negative"]["degrees"], -15);
    EXPECT_EQ(json["beam_angle"]["plane_90"], 30);
}

TEST(LuminaireFacts, NameTheSideOfABeamThatEndsNowhere) {
    const BeamSpread one_sided{.positive = {90, false}, .negative = {-30, true}};
    EXPECT_EQ(spread_text(PhotometricType::c, 0, one_sided),
              "C0-C180: from 30 degrees, not reached within 90 degrees towards C0");
    const BeamSpread from_below{.positive = {-20, false}, .negative = {70, true}};
    EXPECT_EQ(spread_text(PhotometricType::a, 90, from_below),
              "vertical: from at most 20 to 70 degrees towards V < 0");
    const BeamSpread up{.positive = {60, true}, .negative = {60, true}, .opposite = true};
    EXPECT_EQ(spread_text(PhotometricType::c, 90, up), "C90-C270: 120 degrees, about the zenith");
    EXPECT_EQ(spread_text(PhotometricType::b, 0, {}), "horizontal: dark");
}

TEST(LuminaireFacts, RemarkOnAHeaderThatItsTableContradicts) {
    PhotometricWeb web = lambert();
    web.stated = {.output_ratio = 0.9, .reference = 500};
    const LuminaireFacts facts = luminaire_facts("lambert.ldt", web);
    ASSERT_EQ(facts.diagnostics.size(), 1u);
    EXPECT_NE(luminaire_text(facts).find("\nwarning     lambert.ldt: the header states a light "
                                         "output ratio of 90 %"),
              std::string::npos)
        << luminaire_text(facts);
    const auto json = nlohmann::json::parse(luminaire_json(facts));
    EXPECT_EQ(json["diagnostics"][0]["severity"], "warning");
    EXPECT_EQ(json["diagnostics"][0]["entity"], "lambert.ldt");
}

TEST(LuminaireFacts, AbsolutePhotometryHasNoOutputRatio) {
    PhotometricWeb web = lambert();
    web.lamp_flux = 0;
    const auto json = nlohmann::json::parse(luminaire_json(luminaire_facts("x.ies", web)));
    EXPECT_TRUE(json["lamp_flux"].is_null());
    EXPECT_TRUE(json["light_output_ratio"].is_null());
}

TEST(PolarCurve, OfALambertLampIsACircleBelowTheMiddle) {
    const std::string svg = polar_curve_svg(luminaire_facts("lambert.ies", lambert()));
    EXPECT_NE(svg.find("a &lt;lamp&gt;"), std::string::npos);
    const std::size_t begin = svg.find("class=\"main\" d=\"M");
    ASSERT_NE(begin, std::string::npos);
    const std::string path = svg.substr(begin + 17, svg.find('"', begin + 17) - begin - 17);
    int points = 0;
    for (std::size_t i = 0; i < path.size(); i = path.find('L', i) + 1) {
        double x = 0, y = 0;
        ASSERT_EQ(std::sscanf(path.c_str() + i, "%lf %lf", &x, &y), 2);
        const bool dark = x == 320 && y == 340;
        EXPECT_TRUE(dark || std::abs(std::hypot(x - 320, y - 470) - 130) < 0.1) << x << " " << y;
        ++points;
        if (path.find('L', i) == std::string::npos) break;
    }
    EXPECT_EQ(points, 361);
}

} // namespace keiko
