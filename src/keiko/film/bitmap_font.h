#pragma once

#include <cstdint>
#include <span>

namespace keiko {

/// A font for pictures that needs no file: cells of 5 x 7 dots.
constexpr int glyph_width = 5, glyph_height = 7;
/// From the left of one letter to the left of the next, dots.
constexpr int glyph_advance = 6;

/// Columns of a printable ASCII character from the left; bit 0 is the top dot. Others look like
/// a question mark.
std::span<const std::uint8_t, glyph_width> glyph(char character);

} // namespace keiko
