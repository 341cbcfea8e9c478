#include "keiko/render/lighting/shading_grid.h"

#include <gtest/gtest.h>

#include <set>

using namespace keiko;

namespace {

/// All places that are tested for a rectangle.
std::vector<Pixel> places_of(const Rectangle& r) {
    std::vector<Pixel> places = r.odd_places();
    for (const Pixel& p : r.corners()) places.push_back(p);
    for (const Pixel& p : r.middles()) places.push_back(p);
    return places;
}

int widest_step(const std::set<int>& numbers) {
    int widest = 0;
    for (auto next = std::next(numbers.begin()); next != numbers.end(); ++next)
        widest = std::max(widest, *next - *std::prev(next));
    return widest;
}

} // namespace

// Also of those that are narrow, as at the right and lower borders of pictures.
TEST(Rectangle, LeavesNoWideStripWithoutAPlace) {
    for (int width = 0; width <= 16; ++width)
        for (int height = 0; height <= 16; ++height) {
            if (std::max(width, height) < 3) continue;
            const Rectangle r{5, 7, 5 + width, 7 + height};
            std::set<int> columns, rows;
            for (const auto& [x, y] : places_of(r)) {
                EXPECT_TRUE(x >= r.x0 && x <= r.x1 && y >= r.y0 && y <= r.y1);
                columns.insert(x), rows.insert(y);
            }
            EXPECT_LE(widest_step(width < height ? rows : columns), 5) << width << " " << height;
            EXPECT_TRUE(width != height || widest_step(rows) <= 5) << width << " " << height;
        }
}
