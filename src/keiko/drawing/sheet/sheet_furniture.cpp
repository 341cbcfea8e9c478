#include "keiko/drawing/sheet/sheet_furniture.h"

#include "keiko/base/text.h"

#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

namespace keiko {
namespace {

using Anchor = SheetText::Anchor;

// mm on the sheet.
constexpr double margin = 10;
constexpr double block_width = 130, block_height = 26;
constexpr double thick = 0.5, thin = 0.18;
constexpr double title_height = 4, note_height = 2.5, line_step = 4.5;

void add_line(Sheet& sheet, const std::string& layer, double width, std::vector<Vec2> points) {
    layer_of(sheet, layer, width).lines.push_back(std::move(points));
}

void add_box(Sheet& sheet, const Box2& box) {
    const Vec2 &a = box.lower, &b = box.upper;
    add_line(sheet, "frame", thick, {a, {b.x, a.y}, b, {a.x, b.y}, a});
}

Box2 frame_of(const Vec2& paper) {
    return {Vec2(margin), paper - Vec2(margin)};
}

Box2 block_of(const Vec2& paper) {
    const Box2 frame = frame_of(paper);
    return {{frame.upper.x - block_width, frame.lower.y},
            {frame.upper.x, frame.lower.y + block_height}};
}

/// A length of 1, 2 or 5 times a power of ten, at most `most`.
double round_length(double most) {
    const double power = std::pow(10, std::floor(std::log10(most)));
    for (const double step : {5.0, 2.0})
        if (step * power <= most) return step * power;
    return power;
}

/// A length with at most one decimal.
std::string length_text(double length) {
    std::array<char, 32> text{};
    const double rounded = std::round(length * 10) / 10;
    std::snprintf(text.data(), text.size(), rounded == std::round(rounded) ? "%.0f" : "%.1f",
                  rounded);
    return text.data();
}

/// About how many letters of a height fit into a width.
std::size_t letters_in(double width, double height) {
    constexpr double letter = 0.75; // of the height, a wide one
    return static_cast<std::size_t>(width / (letter * height));
}

/// Adds a dimension line between two places with arrows, an extension line at each, and a length.
void add_dimension(Sheet& sheet, const Vec2& a, const Vec2& b, const Vec2& away, double length) {
    constexpr double distance = 10, beyond = 2, arrow = 2.5, half_arrow = 0.5, lift = 1.2;
    const Vec2 from = a + away * distance, to = b + away * distance;
    const Vec2 along = (to - from).normalized(), across(-along.y, along.x);
    const auto draw = [&](std::vector<Vec2> points) {
        add_line(sheet, "dimensions", thin, std::move(points));
    };
    draw({a + away, from + away * beyond});
    draw({b + away, to + away * beyond});
    draw({from, to});
    draw({from + along * arrow + across * half_arrow, from,
          from + along * arrow - across * half_arrow});
    draw({to - along * arrow + across * half_arrow, to, to - along * arrow - across * half_arrow});
    const bool upright = std::abs(along.x) > std::abs(along.y);
    sheet.texts.push_back({(from + to) / 2 + (upright ? Vec2(0, lift) : Vec2(-lift, 0)),
                           note_height, length_text(length), Anchor::middle, upright});
}

} // namespace

Box2 drawing_area(const Vec2& paper) {
    Box2 area = frame_of(paper);
    area.lower.y += block_height;
    return area;
}

void add_frame(Sheet& sheet) {
    add_box(sheet, frame_of(sheet.size));
}

void add_title_block(Sheet& sheet, const std::string& title, std::span<const std::string> notes) {
    const Box2 block = block_of(sheet.size);
    add_box(sheet, block);
    constexpr double inset = 3;
    const double width = block.extent().x - 2 * inset;
    Vec2 at(block.lower.x + inset, block.upper.y - inset - title_height);
    sheet.texts.push_back({at, title_height, shortened(title, letters_in(width, title_height))});
    for (const std::string& note : notes) {
        at.y -= line_step;
        if (at.y < block.lower.y) break;
        sheet.texts.push_back({at, note_height, shortened(note, letters_in(width, note_height))});
    }
}

void add_list(Sheet& sheet, std::span<const std::string> lines) {
    const Box2 block = block_of(sheet.size);
    constexpr double inset = 90; // right of the scale bar
    const double width = block.lower.x - margin - inset;
    Vec2 at(margin + inset, block.upper.y);
    const auto add = [&](const std::string& line) {
        at.y -= line_step;
        sheet.texts.push_back({at, note_height, shortened(line, letters_in(width, note_height))});
    };
    const auto room = static_cast<std::size_t>(block.extent().y / line_step);
    const std::size_t shown = lines.size() <= room ? lines.size() : room - 1;
    for (const std::string& line : lines.first(shown)) add(line);
    if (shown < lines.size())
        add("and " + std::to_string(lines.size() - shown) + " more, which keiko check lists");
}

void add_scale_bar(Sheet& sheet, double scale) {
    constexpr double longest = 70, tick = 2, inset = 8;
    const double length = round_length(longest / scale), on_paper = length * scale;
    const Vec2 from(margin + inset, margin + inset), to = from + Vec2(on_paper, 0);
    const Vec2 half = from + Vec2(on_paper / 2, 0), up(0, tick);
    add_line(sheet, "scale", thick, {from + up, from, to, to + up});
    add_line(sheet, "scale", thick, {half, half + up / 2});
    const Vec2 above(0, tick + 1);
    sheet.texts.push_back({from + above, note_height, "0", Anchor::middle});
    sheet.texts.push_back({to + above, note_height, length_text(length) + " mm", Anchor::middle});
}

void add_dimensions(Sheet& sheet, const Box2& box, const std::optional<double>& width,
                    const std::optional<double>& height) {
    const Vec2 &a = box.lower, &b = box.upper;
    if (width) add_dimension(sheet, a, {b.x, a.y}, {0, -1}, *width);
    if (height) add_dimension(sheet, a, {a.x, b.y}, {-1, 0}, *height);
}

void add_mark(Sheet& sheet, const Vec2& at, std::uint32_t number, bool visible) {
    constexpr double radius = 2.5;
    constexpr int corners = 36;
    std::vector<Vec2> circle;
    for (int i = 0; i <= corners; ++i) {
        const double angle = 2 * std::numbers::pi * (i % corners) / corners;
        circle.push_back(at + Vec2(std::cos(angle), std::sin(angle)) * radius);
    }
    SheetLayer& layer = visible ? layer_of(sheet, "findings", thin)
                                : layer_of(sheet, "findings hidden", thin, true);
    layer.lines.push_back(std::move(circle));
    sheet.texts.push_back(
        {at - Vec2(0, note_height / 2), note_height, std::to_string(number), Anchor::middle});
}

} // namespace keiko
