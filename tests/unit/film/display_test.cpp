#include "keiko/film/contour_lines.h"
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

TEST(Display, SlopeIsThatOfTheTransferFunction) {
    for (const double linear : {1e-4, 2e-3, 0.004, 0.02, 0.3, 0.9}) {
        const double step = 1e-6 * linear;
        const double slope = (srgb_oetf(linear + step) - srgb_oetf(linear - step)) / (2 * step);
        EXPECT_NEAR(srgb_slope(linear), slope, 1e-6 * slope) << linear;
    }
    EXPECT_EQ(srgb_slope(5), srgb_slope(1));
}

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
        EXPECT_EQ(tone_mapped(film, {.curve = curve, .ev = {}}).values,
                  decltype(Image::values)(6, 0));
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

TEST(ToneMapping, TheLogarithmLiftsWhatIsDark) {
    EXPECT_EQ(logarithmic(0), 0);
    EXPECT_DOUBLE_EQ(logarithmic(1), 1);
    EXPECT_NEAR(logarithmic(0.01), std::log(2) / std::log(101), 1e-12);
    const Film film = grey_film(1, 1, {0.01F});
    const Image display =
        tone_mapped(film, {.curve = ToneMapping::Curve::logarithmic, .ev = std::log2(1 / 1.2)});
    EXPECT_NEAR(static_cast<double>(display.values[0]), srgb_oetf(logarithmic(0.01)), 1e-6);
}

TEST(FalseColor, LegendNamesRoundValues) {
    EXPECT_EQ(round_values({1, 10000}), (std::vector<double>{1, 10, 100, 1000, 10000}));
    EXPECT_EQ(round_values({0.3, 20}), (std::vector<double>{0.5, 1, 2, 5, 10, 20}));
    EXPECT_EQ(round_values({0.01, 1}), (std::vector<double>{0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1}));
}

TEST(FalseColor, PictureIsThatOfTheScaleBesideItsLegend) {
    const Film film = grey_film(80, 200, std::vector<float>(16000, 100));
    const FalseColorScale scale;
    const Image picture = false_color_picture(film, scale, true);
    EXPECT_GT(picture.width, 140);
    EXPECT_EQ(picture.height, 200);
    EXPECT_NEAR(picture.pixel(40, 100)[1], 1, 1e-5);
    EXPECT_NEAR(picture.pixel(40, 100)[0], 0, 1e-5);
    // The bar runs from red at its top to blue at its bottom.
    EXPECT_GT(picture.pixel(100, 34)[0], 0.95);
    EXPECT_GT(picture.pixel(100, 180)[2], 0.95);
    bool letters = false;
    for (int y = 0; y < 200; ++y)
        for (int x = 122; x < picture.width; ++x)
            letters = letters || picture.pixel(x, y)[0] > 0.9F;
    EXPECT_TRUE(letters);
}

TEST(IsoLines, FollowTheLevelOfASlopeAndACircle) {
    Image slope(9, 6, 1);
    for (int y = 0; y < 6; ++y)
        for (int x = 0; x < 9; ++x) slope.pixel(x, y)[0] = static_cast<float>(x) + 0.25F;
    const auto straight = iso_lines(slope, 4);
    ASSERT_EQ(straight.size(), 5u);
    for (const Polyline& line : straight)
        for (const Vec2& p : line.points) EXPECT_NEAR(p.x, 3.75 + 0.5, 1e-6);

    Image bowl(64, 64, 1);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            bowl.pixel(x, y)[0] =
                static_cast<float>(std::pow(x + 0.5 - 32, 2) + std::pow(y + 0.5 - 32, 2));
    double length = 0;
    for (const Polyline& line : iso_lines(bowl, 400)) {
        for (const Vec2& p : line.points) EXPECT_NEAR((p - Vec2(32)).length(), 20, 0.02);
        length += (line.points[1] - line.points[0]).length();
    }
    EXPECT_NEAR(length, 40 * std::acos(-1), 0.3);
}

TEST(IsoLines, EndAtPixelsThatAreNoNumbersAndPartSaddlesByTheirMiddle) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    Image broken(2, 2, 1);
    broken.values = {0, 1, nan, 1};
    EXPECT_TRUE(iso_lines(broken, 0.5).empty());
    Image saddle(2, 2, 1);
    saddle.values = {1, 0, 0, 1}; // in circulation 1, 0, 1, 0
    for (const double level : {0.4, 0.6}) {
        const auto lines = iso_lines(saddle, level);
        ASSERT_EQ(lines.size(), 2u);
        // Each line cuts off one corner: the low ones when the middle is above.
        for (const Polyline& line : lines) {
            const Vec2 middle = (line.points[0] + line.points[1]) / 2;
            const bool near_low = (middle - Vec2(1.5, 0.5)).length() < 0.45 ||
                                  (middle - Vec2(0.5, 1.5)).length() < 0.45;
            EXPECT_EQ(near_low, level < 0.5);
        }
    }
}
