#include "keiko/base/error.h"
#include "keiko/film/contour_lines.h"
#include "keiko/film/false_color.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

using namespace keiko;

namespace {

/// The distance from the middle of a square image.
Image cone(int size) {
    Image values(size, size, 1);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            values.pixel(x, y)[0] =
                static_cast<float>(std::hypot(x + 0.5 - size / 2.0, y + 0.5 - size / 2.0));
    return values;
}

double length_of(const Polyline& line) {
    double length = 0;
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
        const double part = (line.points[i + 1] - line.points[i]).length();
        if (std::isfinite(part)) length += part;
    }
    return length;
}

bool inside(const Vec2& point, const TextLabel& text) {
    const Vec2 size = text_size(text.text, text.scale), from = point - text.at;
    return from.x >= 0 && from.y >= 0 && from.x <= size.x && from.y <= size.y;
}

/// Illuminance that doubles from left to right over every 50 pixels, with a strip of background.
Film slope(int width, int height) {
    Film film{Image(width, height, 3), Image(width, height, 1, 1), {}};
    Image lux(width, height, 1);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            lux.pixel(x, y)[0] = static_cast<float>(100 * std::exp2((x + 0.5) / 50));
            if (y < 10) film.alpha.pixel(x, y)[0] = 0;
        }
    film.aovs[Aov::illuminance] = std::move(lux);
    return film;
}

} // namespace

TEST(JoinedLines, MakeOneClosedLineOfACircle) {
    const auto joined = joined_lines(iso_lines(cone(100), 30));
    ASSERT_EQ(joined.size(), 1u);
    EXPECT_NEAR(length_of(joined[0]), 60 * std::numbers::pi, 0.5);
    EXPECT_LT((joined[0].points.front() - joined[0].points.back()).length(), 1e-6);
}

TEST(JoinedLines, KeepOpenLinesAndPartsThatDoNotMeetApart) {
    const Polyline a{.points = {Vec2(0, 0), Vec2(1, 0)}}, b{.points = {Vec2(2, 0), Vec2(1, 0)}},
        c{.points = {Vec2(0, 0), Vec2(0, 1)}}, far{.points = {Vec2(9, 9), Vec2(9, 8)}};
    const auto joined = joined_lines({a, far, b, c});
    ASSERT_EQ(joined.size(), 2u);
    EXPECT_NEAR(length_of(joined[0]), 3, 1e-12);
    EXPECT_EQ(joined[1].points, far.points);
}

TEST(LabelledContours, BreakTheirLinesAtTheirLabels) {
    const Image values = cone(200);
    const Overlay overlay = labelled_contours(
        {{"40", iso_lines(values, 40)}, {"80", iso_lines(values, 80)}}, 200, 200, 1);
    ASSERT_EQ(overlay.texts.size(), 2u);
    for (const TextLabel& text : overlay.texts) {
        const Vec2 middle = text.at + text_size(text.text, 1) / 2;
        EXPECT_NEAR((middle - Vec2(100)).length(), std::stod(text.text), 1);
        for (const Polyline& line : overlay.lines)
            for (const Vec2& point : line.points) EXPECT_FALSE(inside(point, text));
    }
}

TEST(LabelledContours, LeaveOutLabelsThatHaveNoRoom) {
    const Image values = cone(60);
    EXPECT_TRUE(labelled_contours({{"3", iso_lines(values, 3)}}, 60, 60, 1).texts.empty())
        << "the line is too short";
    std::vector<Contour> crowd;
    for (int level = 10; level < 28; ++level)
        crowd.push_back({std::to_string(level), iso_lines(values, level)});
    EXPECT_TRUE(labelled_contours(crowd, 60, 60, 1).texts.empty()) << "no label fits between";
}

TEST(FalseColor, ShowsIlluminanceOfTheBodyAlone) {
    const Film film = slope(100, 80);
    const FalseColorScale scale{100, 400};
    const Image picture = false_color_picture(film, scale, false, ShownQuantity::illuminance);
    EXPECT_EQ(picture.pixel(50, 5)[0], picture.pixel(50, 5)[2]) << "grey behind it";
    for (const int x : {10, 50, 90}) {
        const Rgb color = jet(x / 100.0 + 0.005);
        EXPECT_NEAR(double{picture.pixel(x, 40)[0]}, color.r, 1e-5);
        EXPECT_NEAR(double{picture.pixel(x, 40)[1]}, color.g, 1e-5);
        EXPECT_NEAR(double{picture.pixel(x, 40)[2]}, color.b, 1e-5);
    }
    Film without = film;
    without.aovs.clear();
    EXPECT_THROW(false_color_picture(without, scale, false, ShownQuantity::illuminance), Error);
}

TEST(FalseColor, NarrowScalesHaveTheStepsOfLightingStandards) {
    EXPECT_EQ(round_values({50, 2000}),
              (std::vector<double>{50, 75, 100, 150, 200, 300, 500, 750, 1000, 1500, 2000}));
}

TEST(FalseColor, LettersGrowWithThePicture) {
    const auto letters = [](int height) {
        const Film film{Image(40, height, 3, 1), Image(40, height, 1, 1), {}};
        return false_color_picture(film, {}, false).width - 40;
    };
    EXPECT_EQ(letters(1000), 2 * letters(300));
}
