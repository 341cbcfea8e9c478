#include "keiko/workflow/picture_marks.h"

#include "keiko/film/signed_color_picture.h"
#include "keiko/inspect/check_sentence.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

constexpr Rgb dot_color(1, 0.85, 0); ///< display values

} // namespace

void dot_seam(const MeasuredSeam& seam, const CurvePainter& painter, Overlay& overlay) {
    constexpr double step = 2; // pixels
    for (const std::vector<Vec3>& piece : seam.course) {
        const std::vector<Vec2> drawn = painter.drawn(piece, step);
        for (std::size_t i = 1; i < drawn.size(); i += 4)
            overlay.lines.push_back(
                {.points = {drawn[i - 1], drawn[i]}, .color = dot_color, .width = 2});
    }
}

void ring_opening(const Check& opening, const Camera& camera, Overlay& overlay) {
    constexpr int dots = 32;
    const Vec3 place = opening.worst.place;
    const Vec3 beside = place + camera.axes().right * (0.6 * opening.opening_length);
    const auto middle = project(camera, place), rim = project(camera, beside);
    if (!middle || !rim) return;
    const double radius = (*rim - *middle).length();
    for (int i = 0; i < dots; ++i) {
        const double from = 2 * std::numbers::pi * i / dots, to = from + 2 / radius;
        const auto at = [&](double angle) {
            return *middle + Vec2(std::cos(angle), std::sin(angle)) * radius;
        };
        overlay.lines.push_back({.points = {at(from), at(to)}, .color = dot_color, .width = 2});
    }
}

void add_scale_bar(const Camera& camera, const Vec3& place, Overlay& overlay) {
    constexpr double least = 0.12; // of the picture's width
    constexpr double margin = 10, legend = 14, tick = 4, text_height = 2 * glyph_height;
    const Vec3 right = camera.axes().right;
    const auto from = project(camera, place), to = project(camera, place + right);
    if (!from || !to) return;
    const double pixels = (*to - *from).length(); // a mm
    const double length = round_scale(least * camera.width / pixels);
    const Vec2 left(margin, camera.height - margin - legend), end(margin + length * pixels, left.y);
    const Vec2 up(0, -tick);
    const std::string text = short_number(length) + " mm";
    const double width = std::max(end.x - left.x, text_size(text, TextLabel{}.scale).x);
    const double plate = text_height + 4 * tick; // pixels, its height
    const Vec2 middle = left - Vec2(tick, plate / 2 - tick);
    overlay.lines.push_back({.points = {middle, middle + Vec2(width + 2 * tick, 0)},
                             .color = Rgb(0.02),
                             .width = plate});
    overlay.lines.push_back({.points = {left + up, left, end, end + up}, .color = dot_color});
    overlay.texts.push_back(
        {.at = left - Vec2(0, 2 * tick + text_height), .text = text, .color = dot_color});
}

} // namespace keiko
