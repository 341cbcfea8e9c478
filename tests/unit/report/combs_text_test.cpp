#include "keiko/report/content/combs_text.h"

#include "tests/support/analytic_models.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sstream>

namespace keiko {
namespace {

class CombsText : public testing::Test {
protected:
    CombsText() {
        options.planes = {section_plane("y=0"), section_plane("z=900")};
        options.iso_curves = 1;
        found = comb_curves(model, options);
        curves = found.curves;
    }

    SurfaceModel model = test::sphere_model(test::stretched(Vec3(80), {0, 0, 1}, Vec3(0)));
    CombOptions options;
    FoundCombs found;
    std::vector<CombCurve> curves;
};

TEST_F(CombsText, JsonHoldsTheSamplesOfEveryCurve) {
    const auto json = nlohmann::json::parse(combs_json(found, options.planes, model, "9.9"));
    EXPECT_EQ(json["format"], "keiko-combs/1");
    ASSERT_EQ(json["curves"].size(), curves.size());
    const auto& section = json["curves"][0];
    EXPECT_EQ(section["kind"], "section");
    EXPECT_EQ(section["name"], "y=0");
    EXPECT_TRUE(section["closed"]);
    EXPECT_TRUE(section["inflections"].empty());
    EXPECT_NEAR(section["largest_curvature"]["value"].get<double>(), -1 / 80.0, 1e-9);
    const auto& sample = section["pieces"][0]["samples"][0];
    EXPECT_NEAR(sample["curvature"].get<double>(), -1 / 80.0, 1e-9);
    EXPECT_NEAR(sample["place"][1].get<double>(), 0, 1e-9);
    EXPECT_EQ(json["curves"].back()["kind"], "iso_v");
    ASSERT_EQ(json["remarks"].size(), 1u);
    EXPECT_EQ(json["remarks"][0]["plane"], "z=900");
    EXPECT_EQ(json["remarks"][0]["kind"], "missed");
    EXPECT_NEAR(json["remarks"][0]["body"][1].get<double>(), 80, 1e-9);
}

TEST_F(CombsText, CsvHasARowASample) {
    std::size_t samples = 0;
    for (const CombCurve& curve : curves)
        for (const CombPiece& piece : curve.pieces) samples += piece.samples.size();
    std::istringstream csv(combs_csv(curves, model));
    std::string line;
    std::getline(csv, line);
    const auto commas = std::count(line.begin(), line.end(), ',');
    std::size_t rows = 0;
    while (std::getline(csv, line)) {
        ++rows;
        // The name of an iso-curve holds none.
        EXPECT_EQ(std::count(line.begin(), line.end(), ','), commas) << line;
    }
    EXPECT_EQ(rows, samples);
}

TEST_F(CombsText, PicturesAreOfPlanesThatMeetTheBodyAndOfTheIsoCurves) {
    const std::vector<CombPicture> pictures = comb_pictures(curves, options.planes);
    ASSERT_EQ(pictures.size(), 2u);
    EXPECT_EQ(pictures[0].name, "y=0");
    EXPECT_EQ(pictures[1].file_name(), "combs-iso-curves.svg");
    // 1/80 is within a tooth of 0.02 /mm.
    EXPECT_NE(pictures[0].svg.find("curvature 0.02 /mm, radius 50 mm"), std::string::npos);
    EXPECT_EQ(pictures[0].svg.find("class=\"cut\""), std::string::npos);
    EXPECT_NE(pictures[0].svg.find("class=\"tooth\""), std::string::npos);
}

// Its sample is nearer to its neighbours than teeth stand.
TEST(CombPictures, ShowSpikesAsNarrowAsTheyAre) {
    CombCurve curve;
    curve.pieces.emplace_back();
    for (int i = 0; i <= 10000; ++i) {
        const bool spike = i == 5003;
        const CurveBend bend{spike ? 1 : 0.01, 0, Vec3(0, 0, 1)};
        curve.pieces[0].samples.push_back({Vec3(0.1 * i, 0, 0), 0.1 * i, bend});
    }
    const std::string svg = combs_svg(std::span(&curve, 1), Vec3(0, 1, 0), "spike");
    EXPECT_NE(svg.find("class=\"cut\""), std::string::npos);
}

} // namespace
} // namespace keiko
