#include "keiko/film/false_color.h"
#include "keiko/film/tone_mapping.h"

#include "tests/support/oracle.h"
#include <gtest/gtest.h>

#include <limits>

using namespace keiko;

namespace {

Film grey_film(int width, int height, const std::vector<float>& luminances) {
    Film film{Image(width, height, 3), Image(width, height, 1, 1), {}};
    for (std::size_t i = 0; i < luminances.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) film.color.values[3 * i + c] = luminances[i];
    return film;
}

} // namespace

TEST(Display, AgreesWithOracle) {
    const test::OracleTable table("display");
    test::WorstError x("x"), srgb("srgb"), curve("reinhard"), encoded("reinhard_srgb"),
        position("falsepos"), red("jet_x"), green("jet_y"), blue("jet_z");
    for (const auto& row : table) {
        const double value = row.number("in.L") / saturation_luminance(row.number("in.ev"));
        const double bent = reinhard(value, row.number("in.white"));
        const FalseColorScale scale{row.number("in.Lmin"), row.number("in.Lmax")};
        const double place = scale_position(scale, row.number("in.L"));
        const Rgb color = jet(place);
        x.compare(row, value, row.number("out.x"), 1e-11);
        srgb.compare(row, srgb_oetf(value), row.number("out.srgb"), 1e-11);
        curve.compare(row, bent, row.number("out.reinhard"), 1e-11);
        encoded.compare(row, srgb_oetf(bent), row.number("out.reinhard_srgb"), 1e-11);
        position.compare(row, place, row.number("out.falsepos"), 1e-11);
        red.compare(row, color.r, row.number("out.jet_x"), 1e-11);
        green.compare(row, color.g, row.number("out.jet_y"), 1e-11);
        blue.compare(row, color.b, row.number("out.jet_z"), 1e-11);
    }
}

TEST(Display, ToneMappedPixelsAgreeWithOracle) {
    const test::OracleTable table("display");
    for (const auto& row : table) {
        const Film film = grey_film(1, 1, {static_cast<float>(row.number("in.L"))});
        ToneMapping mapping{.ev = row.number("in.ev"), .white = row.number("in.white")};
        const Image linear = tone_mapped(film, mapping);
        EXPECT_NEAR(static_cast<double>(linear.values[0]), row.number("out.srgb"), 1e-6);
        EXPECT_EQ(std::lround(255 * linear.values[2]), row.integer("out.linear8")) << row.id();
        mapping.curve = ToneMapping::Curve::reinhard;
        EXPECT_NEAR(static_cast<double>(tone_mapped(film, mapping).values[1]),
                    row.number("out.reinhard_srgb"), 1e-6)
            << row.id();
    }
}

TEST(ToneMapping, WhiteIsTheQuantileOfTheCoveredPixels) {
    std::vector<float> values;
    for (int i = 0; i < 200; ++i) values.push_back(static_cast<float>(i < 101 ? i : 1e6));
    Film film = grey_film(20, 10, values);
    for (std::size_t i = 101; i < 200; ++i) film.alpha.values[i] = 0.2F; // background
    EXPECT_NEAR(white_luminance(film), 99, 1e-4);
    std::fill(film.alpha.values.begin(), film.alpha.values.end(), 0.0F);
    EXPECT_NEAR(white_luminance(film), 1e6, 1);
}

TEST(ToneMapping, BlackAndBrokenPixelsStayBlack) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const Film film = grey_film(2, 1, {0, nan});
    EXPECT_EQ(white_luminance(film), 1);
    for (const auto curve : {ToneMapping::Curve::linear, ToneMapping::Curve::reinhard})
        EXPECT_EQ(tone_mapped(film, {.curve = curve, .ev = {}}).values, std::vector<float>(6, 0));
}

TEST(ToneMapping, ReinhardKeepsHueAndReachesWhite) {
    EXPECT_DOUBLE_EQ(reinhard(4, 4), 1);
    Film film = grey_film(1, 1, {0});
    film.color.values = {4, 2, 1};
    const Image display = tone_mapped(
        film, {.curve = ToneMapping::Curve::reinhard, .ev = std::log2(1 / 1.2), .white = 1e9});
    const double y = luminance(Rgb(4, 2, 1));
    EXPECT_NEAR(static_cast<double>(display.values[1]), srgb_oetf(2 / (1 + y)), 1e-6);
    EXPECT_NEAR(static_cast<double>(display.values[2]), srgb_oetf(1 / (1 + y)), 1e-6);
}

TEST(ToneMapping, CarriesAlphaOnRequest) {
    Film film = grey_film(2, 1, {1, 1});
    film.alpha.values = {0.25F, 2};
    const Image display = tone_mapped(film, {}, true);
    ASSERT_EQ(display.channels, 4);
    EXPECT_EQ(display.pixel(0, 0)[3], 0.25F);
    EXPECT_EQ(display.pixel(1, 0)[3], 1);
    film.alpha = {};
    EXPECT_EQ(tone_mapped(film, {}, true).pixel(0, 0)[3], 1);
}

TEST(FalseColor, PaintsTheScale) {
    const Film film = grey_film(5, 1, {1, 10, 100, 1000, 10000});
    const Image image = false_color(film, {1, 10000});
    const std::vector<std::vector<float>> colors{
        {0, 0, 1}, {0, 1, 1}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}};
    for (int x = 0; x < 5; ++x)
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(image.pixel(x, 0)[c],
                        colors[static_cast<std::size_t>(x)][static_cast<std::size_t>(c)], 1e-5);
}
