#pragma once

#include "keiko/film/film.h"
#include "keiko/math/vec.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace keiko {

/// Width in dots of a letter of the built-in font for pictures, which needs no file.
constexpr int glyph_width = 5;
/// Height in dots of a letter of that font.
constexpr int glyph_height = 7;
/// From the left of one letter to the left of the next, dots.
constexpr int glyph_advance = 6;

/// Columns of a printable ASCII character from the left; bit 0 is the top dot. Others look like
/// a question mark.
std::span<const std::uint8_t, glyph_width> glyph(char character);

/// A line through points in pixel coordinates, (0, 0) being the picture's upper left corner and
/// (0.5, 0.5) the centre of its first pixel. It breaks at points that are not finite.
struct Polyline {
    std::vector<Vec2> points{}; ///< pixels, in order
    Rgb color{1, 0.2, 0.1};     ///< display values, 0 to 1
    double width = 1.5;         ///< pixels
};

/// A disc with a short label in it: the numbered worst places of a picture. It grows to hold its
/// label, which is black or white, whichever stands out.
struct Marker {
    Vec2 at{0};            ///< its centre
    std::string label{};   ///< a few characters, such as a number; "": none
    Rgb color{1, 0.85, 0}; ///< display values of the disc, 0 to 1
    double radius = 11;    ///< pixels
};

/// A line of text in the built-in font; characters beyond ASCII show as question marks.
struct TextLabel {
    Vec2 at{0};         ///< upper left corner of the first letter
    std::string text{}; ///< one line
    Rgb color{1, 1, 1}; ///< display values, 0 to 1
    int scale = 2;      ///< pixels a dot; a letter is 5 x 7 dots
};

/// Drawing onto a picture: lines, then markers, then texts.
struct Overlay {
    std::vector<Polyline> lines{};  ///< drawn first, in order
    std::vector<Marker> markers{};  ///< drawn over the lines, in order
    std::vector<TextLabel> texts{}; ///< drawn over all else, in order
};

/// A display picture (3 or 4 channels in [0, 1]; alpha rises where something is drawn) with the
/// overlay on it, antialiased. What lies outside is cut off.
Image with_overlay(Image display, const Overlay& overlay);

/// Size of a text in pixels.
Vec2 text_size(const std::string& text, int scale);

} // namespace keiko
