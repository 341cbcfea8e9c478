#include "keiko/film/iso_lines.h"

#include <array>
#include <cmath>

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

} // namespace keiko
