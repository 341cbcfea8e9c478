#include "keiko/film/overlay.h"

#include <gtest/gtest.h>

#include <limits>

using namespace keiko;

namespace {

/// Red of the drawn pixels on black.
Image drawn(const Overlay& overlay, int width = 60, int height = 40) {
    return with_overlay(Image(width, height, 3), overlay);
}

double ink(const Image& image) {
    double sum = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) sum += static_cast<double>(image.pixel(x, y)[0]);
    return sum;
}

const Rgb red(1, 0, 0);

} // namespace

TEST(Overlay, LeavesThePictureAloneWithoutContent) {
    EXPECT_EQ(with_overlay(Image(5, 4, 3, 0.3F), {}).values, Image(5, 4, 3, 0.3F).values);
}

TEST(Overlay, LineCoversItsAreaWhereverItLies) {
    for (const double shift : {0.0, 0.25, 0.5, 0.9}) {
        const Vec2 a(10 + shift, 10.3), b(50 + shift, 10.3 + shift * 20);
        const Image image = drawn({.lines = {{{a, b}, red, 3}}});
        const double length = (b - a).length();
        EXPECT_NEAR(ink(image), 3 * length + 9 * 0.785, 0.03 * 3 * length) << shift;
    }
}

TEST(Overlay, LineRunsThroughItsPoints) {
    const Polyline line{{{10, 10.5}, {50, 10.5}, {50.5, 30}}, red, 2};
    const Image image = drawn({.lines = {line}});
    EXPECT_EQ(image.pixel(30, 10)[0], 1);
    EXPECT_EQ(image.pixel(50, 20)[0], 1);
    EXPECT_EQ(image.pixel(30, 20)[0], 0);
    EXPECT_EQ(image.pixel(30, 13)[0], 0);
    EXPECT_EQ(image.pixel(30, 10)[1], 0);
}

TEST(Overlay, ThinLinesFadeAndJointsDoNotShow) {
    const Polyline whole{{{10, 10.5}, {50, 10.5}}, red, 0.5};
    const Polyline joined{{{10, 10.5}, {20, 10.5}, {20, 10.5}, {35, 10.5}, {50, 10.5}}, red, 0.5};
    const Image image = drawn({.lines = {whole}});
    EXPECT_EQ(image.pixel(30, 10)[0], 0.5F);
    EXPECT_EQ(image.values, drawn({.lines = {joined}}).values);
}

TEST(Overlay, WhatLiesOutsideOrIsNotFiniteIsCutOff) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Polyline far{{{-1e9, 20.5}, {1e9, 20.5}}, red, 1};
    const Polyline broken{{{5, 5}, {nan, 5}, {7, 5}}, red, 1};
    const Image image = drawn({.lines = {far, broken},
                               .markers = {{{nan, 3}, "1"}, {{-500, 3}, "2"}},
                               .texts = {{{1e9, 0}, "x"}, {{nan, 0}, "y"}}});
    EXPECT_EQ(image.pixel(0, 20)[0], 1);
    EXPECT_EQ(image.pixel(59, 20)[0], 1);
    EXPECT_NEAR(ink(image), 60, 0.05);
}

TEST(Overlay, MarkerIsADiscWithItsNumber) {
    const Marker marker{{30, 20}, "3", {1, 1, 0}, 11};
    const Image image = drawn({.markers = {marker}});
    EXPECT_EQ(image.pixel(30, 11)[1], 1) << "above the digit";
    EXPECT_EQ(image.pixel(30, 4)[1], 0) << "outside";
    int dark = 0;
    for (int y = 13; y < 27; ++y)
        for (int x = 25; x < 35; ++x) dark += image.pixel(x, y)[1] == 0;
    int dots = 0;
    for (const std::uint8_t column : glyph('3'))
        for (int row = 0; row < glyph_height; ++row) dots += column >> row & 1;
    EXPECT_EQ(dark, 4 * dots);
}

TEST(Overlay, MarkerGrowsWithItsLabel) {
    const Image small = drawn({.markers = {{{30, 20}, "1", red, 8}}});
    const Image large = drawn({.markers = {{{30, 20}, "123", red, 8}}});
    EXPECT_EQ(small.pixel(45, 20)[0], 0);
    EXPECT_EQ(large.pixel(48, 20)[0], 1);
}

TEST(Overlay, TextShowsItsGlyphs) {
    const Image image = drawn({.texts = {{{3, 2}, "-T", red, 1}}});
    for (int x = 3; x < 8; ++x) EXPECT_EQ(image.pixel(x, 5)[0], 1);
    for (int y = 2; y < 9; ++y) EXPECT_EQ(image.pixel(11, y)[0], 1);
    EXPECT_EQ(ink(image), 5 + 5 + 6);
    EXPECT_EQ(text_size("-T", 3), Vec2(33, 21));
}

TEST(Overlay, EveryPrintableCharacterHasAGlyphOfItsOwn) {
    for (char a = '!'; a <= '~'; ++a) {
        for (char b = ' '; b < a; ++b) {
            const auto left = glyph(a), right = glyph(b);
            EXPECT_FALSE(std::equal(left.begin(), left.end(), right.begin())) << a << b;
        }
    }
    EXPECT_EQ(glyph('\xb0').data(), glyph('?').data());
}

TEST(Overlay, DrawnPixelsBecomeOpaque) {
    const Image image =
        with_overlay(Image(20, 10, 4), {.lines = {{{{0, 5.5}, {20, 5.5}}, red, 1}}});
    EXPECT_EQ(image.pixel(10, 5)[3], 1);
    EXPECT_EQ(image.pixel(10, 8)[3], 0);
}
