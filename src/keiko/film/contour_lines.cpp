#include "keiko/film/contour_lines.h"

#include "keiko/math/bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace keiko {
namespace {

/// Four neighbouring pixel centres, in circulation, with what they have above the level.
struct Cell {
    std::array<Vec2, 4> corners;
    std::array<double, 4> above{};

    Cell(const Image& values, int x, int y, int channel, double level)
        : corners{Vec2(x + 0.5, y + 0.5), Vec2(x + 1.5, y + 0.5), Vec2(x + 1.5, y + 1.5),
                  Vec2(x + 0.5, y + 1.5)} {
        constexpr int dx[] = {0, 1, 1, 0}, dy[] = {0, 0, 1, 1};
        for (std::size_t i = 0; i < 4; ++i)
            above[i] = static_cast<double>(values.pixel(x + dx[i], y + dy[i])[channel]) - level;
    }
    bool finite() const {
        return std::isfinite(above[0]) && std::isfinite(above[1]) && std::isfinite(above[2]) &&
               std::isfinite(above[3]);
    }
    bool crosses(std::size_t side) const {
        return (above[side] >= 0) != (above[(side + 1) % 4] >= 0);
    }
    Vec2 crossing(std::size_t side) const {
        const double a = above[side], b = above[(side + 1) % 4];
        return corners[side] + (corners[(side + 1) % 4] - corners[side]) * (a / (a - b));
    }
};

/// At a saddle the middle decides which crossings belong together.
void add_lines(const Cell& cell, std::vector<Polyline>& lines) {
    std::array<std::size_t, 4> sides{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < 4; ++i)
        if (cell.crosses(i)) sides[count++] = i;
    const auto add = [&](std::size_t a, std::size_t b) {
        lines.push_back({.points = {cell.crossing(sides[a]), cell.crossing(sides[b])}});
    };
    if (count == 2) return add(0, 1);
    if (count != 4) return;
    const double middle = cell.above[0] + cell.above[1] + cell.above[2] + cell.above[3];
    const bool around_first = (middle >= 0) != (cell.above[0] >= 0);
    add(0, around_first ? 3 : 1);
    add(around_first ? 1 : 2, around_first ? 2 : 3);
}

} // namespace

std::vector<Polyline> iso_lines(const Image& values, double level, int channel) {
    std::vector<Polyline> lines;
    for (int y = 0; y + 1 < values.height; ++y)
        for (int x = 0; x + 1 < values.width; ++x) {
            const Cell cell(values, x, y, channel, level);
            if (cell.finite()) add_lines(cell, lines);
        }
    return lines;
}

namespace {

/// Ends of neighbouring parts are computed apart, and differ by rounding.
using Place = std::pair<long, long>;
Place place_of(const Vec2& point) {
    constexpr double steps = 256; // a pixel
    return {std::lround(point.x * steps), std::lround(point.y * steps)};
}

/// Parts by where they end, and which are still free.
class Parts {
public:
    explicit Parts(const std::vector<Polyline>& parts) : parts_(parts), free_(parts.size(), true) {
        for (std::size_t i = 0; i < parts.size(); ++i) {
            at_[place_of(parts[i].points.front())].push_back(i);
            at_[place_of(parts[i].points.back())].push_back(i);
        }
    }

    bool take(std::size_t part) {
        const bool was_free = free_[part];
        free_[part] = false;
        return was_free;
    }
    /// Puts free parts behind the last point of the line while there are any.
    void extend(std::vector<Vec2>& line) {
        while (const auto next = next_at(line.back())) {
            std::vector<Vec2> points = parts_[*next].points;
            if (place_of(points.front()) != place_of(line.back()))
                std::reverse(points.begin(), points.end());
            line.insert(line.end(), points.begin() + 1, points.end());
        }
    }

private:
    std::optional<std::size_t> next_at(const Vec2& end) {
        for (const std::size_t part : at_[place_of(end)])
            if (take(part)) return part;
        return {};
    }

    const std::vector<Polyline>& parts_;
    std::vector<bool> free_;
    std::map<Place, std::vector<std::size_t>> at_;
};

/// Pixels of a picture, each with what stands on it: one of the lines, a label, or nothing.
class Occupied {
public:
    Occupied(int width, int height)
        : width_(width),
          height_(height),
          by_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), nobody) {}

    void add_line(const Vec2& point, int line) {
        const int x = static_cast<int>(point.x), y = static_cast<int>(point.y);
        if (x >= 0 && x < width_ && y >= 0 && y < height_) at(x, y) = line;
    }
    /// True if a box lies in the picture with nothing in it but one line.
    bool holds_only(const Box2& box, int line) {
        if (box.lower.x < 0 || box.lower.y < 0 || box.upper.x >= width_ || box.upper.y >= height_)
            return false;
        return every(box, [&](int by) { return by == nobody || by == line; });
    }
    void add_label(const Box2& box) {
        every(box, [](int& by) {
            by = a_label;
            return true;
        });
    }

private:
    static constexpr int nobody = -1, a_label = -2;

    int& at(int x, int y) {
        return by_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                   static_cast<std::size_t>(x)];
    }
    template <class F>
    bool every(const Box2& box, const F& holds) {
        for (int y = static_cast<int>(box.lower.y); y <= static_cast<int>(box.upper.y); ++y)
            for (int x = static_cast<int>(box.lower.x); x <= static_cast<int>(box.upper.x); ++x)
                if (!holds(at(x, y))) return false;
        return true;
    }

    int width_, height_;
    std::vector<int> by_;
};

Box2 box_around(const Vec2& middle, const Vec2& size) {
    return {middle - size / 2, middle + size / 2};
}

double length_of(const Polyline& line) {
    double length = 0;
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
        length += (line.points[i + 1] - line.points[i]).length();
    return length;
}

/// Takes the points inside of the box out of the line, which breaks there.
void break_in(Polyline& line, const Box2& box) {
    for (Vec2& point : line.points)
        if (box.contains(point)) point = Vec2(std::numeric_limits<double>::quiet_NaN());
}

/// Places along a line where its label may stand, the best first, as shares of its points. A line
/// has a point a pixel or more.
constexpr double places[] = {0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8, 0.1, 0.9};
/// Times its label that a line is long at least, to have one.
constexpr double least_length = 5;

/// Sets the label of a line and breaks the line there, if it is long enough and there is room.
void set_label(Polyline& line, int number, const std::string& label, int scale, Occupied& occupied,
               std::vector<TextLabel>& texts) {
    const Vec2 size = text_size(label, scale), around = size + Vec2(4.0 * scale);
    if (length_of(line) < least_length * size.x) return;
    const auto count = static_cast<double>(line.points.size());
    for (const double share : places) {
        const Vec2 middle = line.points[static_cast<std::size_t>(share * count)];
        const Box2 box = box_around(middle, around);
        if (!occupied.holds_only(box, number)) continue;
        occupied.add_label(box);
        texts.push_back(
            {.at = middle - size / 2, .text = label, .color = line.color, .scale = scale});
        break_in(line, box);
        return;
    }
}

} // namespace

std::vector<Polyline> joined_lines(const std::vector<Polyline>& parts) {
    Parts ends(parts);
    std::vector<Polyline> joined;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (!ends.take(i)) continue;
        Polyline line = parts[i];
        ends.extend(line.points);
        std::reverse(line.points.begin(), line.points.end());
        ends.extend(line.points);
        std::reverse(line.points.begin(), line.points.end());
        joined.push_back(std::move(line));
    }
    return joined;
}

Overlay labelled_contours(const std::vector<Contour>& contours, int width, int height, int scale) {
    std::vector<std::vector<Polyline>> joined;
    Occupied occupied(width, height);
    int number = 0;
    for (const Contour& contour : contours) {
        joined.push_back(joined_lines(contour.lines));
        for (const Polyline& line : joined.back()) {
            for (const Vec2& point : line.points) occupied.add_line(point, number);
            ++number;
        }
    }
    Overlay overlay;
    number = 0;
    for (std::size_t i = 0; i < contours.size(); ++i)
        for (Polyline& line : joined[i]) {
            set_label(line, number++, contours[i].label, scale, occupied, overlay.texts);
            overlay.lines.push_back(std::move(line));
        }
    return overlay;
}

} // namespace keiko
