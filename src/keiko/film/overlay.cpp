#include "keiko/film/overlay.h"

#include "keiko/math/bounds.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keiko {
namespace {

using Columns = std::array<std::uint8_t, glyph_width>;

constexpr char first_glyph = ' ', last_glyph = '~';

// clang-format off
constexpr std::array<Columns, last_glyph - first_glyph + 1> glyphs{{
    {{0x00, 0x00, 0x00, 0x00, 0x00}}, {{0x00, 0x00, 0x5F, 0x00, 0x00}}, {{0x00, 0x07, 0x00, 0x07, 0x00}}, {{0x14, 0x7F, 0x14, 0x7F, 0x14}}, //   ! " #
    {{0x24, 0x2A, 0x7F, 0x2A, 0x12}}, {{0x23, 0x13, 0x08, 0x64, 0x62}}, {{0x36, 0x49, 0x56, 0x20, 0x50}}, {{0x00, 0x00, 0x07, 0x00, 0x00}}, // $ % & '
    {{0x00, 0x1C, 0x22, 0x41, 0x00}}, {{0x00, 0x41, 0x22, 0x1C, 0x00}}, {{0x2A, 0x1C, 0x7F, 0x1C, 0x2A}}, {{0x08, 0x08, 0x3E, 0x08, 0x08}}, // ( ) * +
    {{0x00, 0x50, 0x30, 0x00, 0x00}}, {{0x08, 0x08, 0x08, 0x08, 0x08}}, {{0x00, 0x60, 0x60, 0x00, 0x00}}, {{0x20, 0x10, 0x08, 0x04, 0x02}}, // , - . /
    {{0x3E, 0x51, 0x49, 0x45, 0x3E}}, {{0x00, 0x42, 0x7F, 0x40, 0x00}}, {{0x42, 0x61, 0x51, 0x49, 0x46}}, {{0x21, 0x41, 0x45, 0x4B, 0x31}}, // 0 1 2 3
    {{0x18, 0x14, 0x12, 0x7F, 0x10}}, {{0x27, 0x45, 0x45, 0x45, 0x39}}, {{0x3C, 0x4A, 0x49, 0x49, 0x30}}, {{0x01, 0x71, 0x09, 0x05, 0x03}}, // 4 5 6 7
    {{0x36, 0x49, 0x49, 0x49, 0x36}}, {{0x06, 0x49, 0x49, 0x29, 0x1E}}, {{0x00, 0x36, 0x36, 0x00, 0x00}}, {{0x00, 0x56, 0x36, 0x00, 0x00}}, // 8 9 : ;
    {{0x08, 0x14, 0x22, 0x41, 0x00}}, {{0x14, 0x14, 0x14, 0x14, 0x14}}, {{0x00, 0x41, 0x22, 0x14, 0x08}}, {{0x02, 0x01, 0x51, 0x09, 0x06}}, // < = > ?
    {{0x32, 0x49, 0x79, 0x41, 0x3E}}, {{0x7E, 0x11, 0x11, 0x11, 0x7E}}, {{0x7F, 0x49, 0x49, 0x49, 0x36}}, {{0x3E, 0x41, 0x41, 0x41, 0x22}}, // @ A B C
    {{0x7F, 0x41, 0x41, 0x22, 0x1C}}, {{0x7F, 0x49, 0x49, 0x49, 0x41}}, {{0x7F, 0x09, 0x09, 0x09, 0x01}}, {{0x3E, 0x41, 0x49, 0x49, 0x7A}}, // D E F G
    {{0x7F, 0x08, 0x08, 0x08, 0x7F}}, {{0x00, 0x41, 0x7F, 0x41, 0x00}}, {{0x20, 0x40, 0x41, 0x3F, 0x01}}, {{0x7F, 0x08, 0x14, 0x22, 0x41}}, // H I J K
    {{0x7F, 0x40, 0x40, 0x40, 0x40}}, {{0x7F, 0x02, 0x0C, 0x02, 0x7F}}, {{0x7F, 0x04, 0x08, 0x10, 0x7F}}, {{0x3E, 0x41, 0x41, 0x41, 0x3E}}, // L M N O
    {{0x7F, 0x09, 0x09, 0x09, 0x06}}, {{0x3E, 0x41, 0x51, 0x21, 0x5E}}, {{0x7F, 0x09, 0x19, 0x29, 0x46}}, {{0x46, 0x49, 0x49, 0x49, 0x31}}, // P Q R S
    {{0x01, 0x01, 0x7F, 0x01, 0x01}}, {{0x3F, 0x40, 0x40, 0x40, 0x3F}}, {{0x1F, 0x20, 0x40, 0x20, 0x1F}}, {{0x3F, 0x40, 0x38, 0x40, 0x3F}}, // T U V W
    {{0x63, 0x14, 0x08, 0x14, 0x63}}, {{0x07, 0x08, 0x70, 0x08, 0x07}}, {{0x61, 0x51, 0x49, 0x45, 0x43}}, {{0x00, 0x7F, 0x41, 0x41, 0x00}}, // X Y Z [
    {{0x02, 0x04, 0x08, 0x10, 0x20}}, {{0x00, 0x41, 0x41, 0x7F, 0x00}}, {{0x04, 0x02, 0x01, 0x02, 0x04}}, {{0x40, 0x40, 0x40, 0x40, 0x40}}, // \ ] ^ _
    {{0x00, 0x01, 0x02, 0x04, 0x00}}, {{0x20, 0x54, 0x54, 0x54, 0x78}}, {{0x7F, 0x48, 0x44, 0x44, 0x38}}, {{0x38, 0x44, 0x44, 0x44, 0x20}}, // ` a b c
    {{0x38, 0x44, 0x44, 0x48, 0x7F}}, {{0x38, 0x54, 0x54, 0x54, 0x18}}, {{0x08, 0x7E, 0x09, 0x01, 0x02}}, {{0x0C, 0x52, 0x52, 0x52, 0x3E}}, // d e f g
    {{0x7F, 0x08, 0x04, 0x04, 0x78}}, {{0x00, 0x44, 0x7D, 0x40, 0x00}}, {{0x20, 0x40, 0x44, 0x3D, 0x00}}, {{0x7F, 0x10, 0x28, 0x44, 0x00}}, // h i j k
    {{0x00, 0x41, 0x7F, 0x40, 0x00}}, {{0x7C, 0x04, 0x18, 0x04, 0x78}}, {{0x7C, 0x08, 0x04, 0x04, 0x78}}, {{0x38, 0x44, 0x44, 0x44, 0x38}}, // l m n o
    {{0x7C, 0x14, 0x14, 0x14, 0x08}}, {{0x08, 0x14, 0x14, 0x18, 0x7C}}, {{0x7C, 0x08, 0x04, 0x04, 0x08}}, {{0x48, 0x54, 0x54, 0x54, 0x20}}, // p q r s
    {{0x04, 0x3F, 0x44, 0x40, 0x20}}, {{0x3C, 0x40, 0x40, 0x20, 0x7C}}, {{0x1C, 0x20, 0x40, 0x20, 0x1C}}, {{0x3C, 0x40, 0x30, 0x40, 0x3C}}, // t u v w
    {{0x44, 0x28, 0x10, 0x28, 0x44}}, {{0x0C, 0x50, 0x50, 0x50, 0x3C}}, {{0x44, 0x64, 0x54, 0x4C, 0x44}}, {{0x00, 0x08, 0x36, 0x41, 0x00}}, // x y z {
    {{0x00, 0x00, 0x7F, 0x00, 0x00}}, {{0x00, 0x41, 0x36, 0x08, 0x00}}, {{0x08, 0x04, 0x08, 0x10, 0x08}}, // | } ~
}};
// clang-format on

} // namespace

std::span<const std::uint8_t, glyph_width> glyph(char character) {
    const bool known = character >= first_glyph && character <= last_glyph;
    return glyphs[static_cast<std::size_t>((known ? character : '?') - first_glyph)];
}

namespace {

bool is_finite(const Vec2& p) {
    return std::isfinite(p.x) && std::isfinite(p.y);
}

/// Pixels of a picture that a box touches.
struct PixelRange {
    int left = 0, top = 0, right = 0, bottom = 0; ///< right and bottom excluded

    PixelRange(const Image& image, const Box2& box)
        : left(floor_within(box.lower.x, image.width)),
          top(floor_within(box.lower.y, image.height)),
          right(floor_within(box.upper.x + 1, image.width)),
          bottom(floor_within(box.upper.y + 1, image.height)) {}

private:
    static int floor_within(double x, int size) {
        return static_cast<int>(std::clamp(std::floor(x), 0.0, static_cast<double>(size)));
    }
};

/// Share of each pixel that one shape covers. A shape's parts join by their maximum, so that the
/// joints of a translucent line do not show.
class Coverage {
public:
    Coverage(const Image& image, const Box2& box)
        : range_(image, box),
          values_(static_cast<std::size_t>(std::max(range_.right - range_.left, 0)) *
                  static_cast<std::size_t>(std::max(range_.bottom - range_.top, 0))) {}

    /// Raises the pixels of `box` to `share` of their centre.
    template <class F>
    void raise(const Image& image, const Box2& box, const F& share) {
        const PixelRange part(image, box);
        const int left = std::max(part.left, range_.left);
        const int right = std::min(part.right, range_.right);
        const int bottom = std::min(part.bottom, range_.bottom);
        for (int y = std::max(part.top, range_.top); y < bottom; ++y) {
            for (int x = left; x < right; ++x) {
                float& value = at(x, y);
                value = std::max(value, static_cast<float>(share(Vec2(x + 0.5, y + 0.5))));
            }
        }
    }

    void blend_onto(Image& image, const Rgb& color) {
        const float target[4] = {static_cast<float>(color.r), static_cast<float>(color.g),
                                 static_cast<float>(color.b), 1};
        const int channels = std::min(image.channels, 4);
        for (int y = range_.top; y < range_.bottom; ++y) {
            for (int x = range_.left; x < range_.right; ++x) {
                float* pixel = image.pixel(x, y);
                for (int c = 0; c < channels; ++c) pixel[c] += (target[c] - pixel[c]) * at(x, y);
            }
        }
    }

private:
    float& at(int x, int y) {
        return values_[static_cast<std::size_t>(y - range_.top) *
                           static_cast<std::size_t>(range_.right - range_.left) +
                       static_cast<std::size_t>(x - range_.left)];
    }

    PixelRange range_;
    std::vector<float> values_;
};

double distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
    const Vec2 along = b - a;
    const double square = along.dot(along);
    const double t = square > 0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0;
    return (a + along * t - p).length();
}

/// Share of a pixel inside an edge, by the distance of its centre from it (inside: positive).
double edge_share(double inside) {
    return std::clamp(inside + 0.5, 0.0, 1.0);
}

void draw(Image& image, const Polyline& line) {
    // A line thinner than a pixel is drawn a pixel wide and fainter.
    const double half = std::max(line.width, 1.0) / 2, strength = std::min(line.width, 1.0);
    Box2 box;
    for (const Vec2& p : line.points)
        if (is_finite(p)) box.extend(p);
    if (box.empty()) return;
    Coverage coverage(image, box.padded(half + 1));
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
        const Vec2 a = line.points[i], b = line.points[i + 1];
        if (!is_finite(a) || !is_finite(b)) continue;
        Box2 segment;
        segment.extend(a);
        segment.extend(b);
        coverage.raise(image, segment.padded(half + 1), [&](const Vec2& p) {
            return strength * edge_share(half - distance_to_segment(p, a, b));
        });
    }
    coverage.blend_onto(image, line.color);
}

void draw(Image& image, const TextLabel& label) {
    if (!is_finite(label.at) || label.scale < 1 || label.text.empty()) return;
    const double scale = label.scale;
    // Whole pixels keep the dots crisp.
    const Vec2 at(std::round(label.at.x), std::round(label.at.y));
    const Box2 box{at, at + text_size(label.text, label.scale)};
    Coverage coverage(image, box);
    coverage.raise(image, box, [&](const Vec2& p) {
        const Vec2 dot = (p - at) / scale;
        const int column = static_cast<int>(std::floor(dot.x)) % glyph_advance;
        const auto letter = static_cast<std::size_t>(std::floor(dot.x) / glyph_advance);
        const int row = static_cast<int>(std::floor(dot.y));
        if (letter >= label.text.size() || column >= glyph_width || row >= glyph_height) return 0;
        const auto columns = glyph(label.text[letter]);
        return columns[static_cast<std::size_t>(column)] >> row & 1;
    });
    coverage.blend_onto(image, label.color);
}

void draw_disc(Image& image, const Vec2& center, double radius, const Rgb& color) {
    const Box2 box{center - Vec2(radius + 1), center + Vec2(radius + 1)};
    Coverage coverage(image, box);
    coverage.raise(image, box,
                   [&](const Vec2& p) { return edge_share(radius - (p - center).length()); });
    coverage.blend_onto(image, color);
}

void draw(Image& image, const Marker& marker) {
    if (!is_finite(marker.at)) return;
    constexpr int scale = 2;
    constexpr double rim = 1.5, margin = 2;
    const Vec2 size = text_size(marker.label, scale);
    const double radius = std::max(marker.radius, size.length() / 2 + margin);
    const Rgb ink = luminance(marker.color) > 0.4 ? Rgb(0) : Rgb(1);
    draw_disc(image, marker.at, radius + rim, ink);
    draw_disc(image, marker.at, radius, marker.color);
    draw(image, TextLabel{marker.at - size / 2, marker.label, ink, scale});
}

} // namespace

Vec2 text_size(const std::string& text, int scale) {
    if (text.empty()) return Vec2(0);
    const double dots = static_cast<double>(text.size()) * glyph_advance - 1;
    return Vec2(dots, glyph_height) * scale;
}

Image with_overlay(Image display, const Overlay& overlay) {
    for (const Polyline& line : overlay.lines) draw(display, line);
    for (const Marker& marker : overlay.markers) draw(display, marker);
    for (const TextLabel& text : overlay.texts) draw(display, text);
    return display;
}

} // namespace keiko
