#include "keiko/render/outline_rows.h"

#include "keiko/render/spot_grid.h"

#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

using namespace keiko;

namespace {

/// A spot of a plane at a height in which pixels are 5 mm wide.
LitSpot spot_at(const Vec2& place, double height) {
    LitSpot spot;
    spot.place = {Vec3(5 * place.x, 5 * place.y, height), Vec3(0, 0, 1), 0};
    return spot;
}

std::vector<OutlineSpot> of(const std::vector<Pixel>& pixels, const std::vector<LitSpot>& spots) {
    std::vector<OutlineSpot> outline;
    for (std::size_t i = 0; i < pixels.size(); ++i) outline.push_back({pixels[i], &spots[i]});
    return outline;
}

/// What a row is: on one line of the picture, and in order along the surface.
void expect_row(const OutlineRow& row, const std::map<const LitSpot*, Pixel>& pixel_of) {
    ASSERT_EQ(row.spots.size(), row.along.size());
    EXPECT_TRUE(std::is_sorted(row.along.begin(), row.along.end()));
    const auto place = [&](const LitSpot* spot) {
        const Pixel pixel = pixel_of.at(spot);
        return Vec2(pixel.x, pixel.y);
    };
    const Vec2 first = place(row.spots.front()), way = place(row.spots.back()) - first;
    for (const LitSpot* spot : row.spots) {
        const double off = std::abs(way.cross(place(spot) - first));
        EXPECT_LE(off, 4 * way.length()); // the ends on the surface may be others than of pixels
    }
}

} // namespace

// Along a wave every pixel is in one row, and rows are long where the wave is straight.
TEST(OutlineRows, HoldEachPixelOfAWaveOnce) {
    test::Random random(5);
    std::vector<Pixel> pixels;
    std::vector<LitSpot> spots;
    for (int x = 0; x < 64; ++x) {
        const double y = 30 + 12 * std::sin(x / 9.0);
        pixels.push_back({x, static_cast<int>(y)});
        spots.push_back(spot_at({x + test::uniform(random, 0, 1), y}, 0));
    }
    std::map<const LitSpot*, Pixel> pixel_of;
    for (std::size_t i = 0; i < spots.size(); ++i) pixel_of[&spots[i]] = pixels[i];
    const std::vector<OutlineRow> rows = outline_rows(of(pixels, spots));
    std::multiset<const LitSpot*> all;
    for (const OutlineRow& row : rows) {
        expect_row(row, pixel_of);
        all.insert(row.spots.begin(), row.spots.end());
    }
    EXPECT_EQ(all.size(), spots.size());
    EXPECT_EQ(std::set(all.begin(), all.end()).size(), spots.size());
    EXPECT_GT(rows.size(), 3u);
    EXPECT_LT(rows.size(), 10u);
}

// Two planes a step apart show in the same pixels: their spots never come to one row.
TEST(OutlineRows, AreOfOneSurface) {
    std::vector<Pixel> pixels;
    std::vector<LitSpot> spots;
    for (int x = 0; x < 20; ++x)
        for (const double height : {0.0, 400.0}) {
            pixels.push_back({x, 3});
            spots.push_back(spot_at({x + 0.5, 3.5}, height));
        }
    const std::vector<OutlineRow> rows = outline_rows(of(pixels, spots));
    ASSERT_EQ(rows.size(), 2u);
    for (const OutlineRow& row : rows) {
        ASSERT_EQ(row.spots.size(), 20u);
        for (const LitSpot* spot : row.spots)
            EXPECT_EQ(spot->place.position.z, row.spots[0]->place.position.z);
    }
}

// Two places of one surface in each pixel, as beside a thin bar: no row holds a pixel twice.
TEST(OutlineRows, HoldNoPixelTwice) {
    std::vector<Pixel> pixels;
    std::vector<LitSpot> spots;
    for (int x = 0; x < 8; ++x)
        for (const double y : {3.1, 3.9}) {
            pixels.push_back({x, 3});
            spots.push_back(spot_at({x + 0.5, y}, 0));
        }
    std::size_t count = 0;
    for (const OutlineRow& row : outline_rows(of(pixels, spots))) {
        EXPECT_EQ(row.spots.size(), 1u);
        count += row.spots.size();
    }
    EXPECT_EQ(count, spots.size());
}

// What is tested of a row besides its middle are the places farthest off on either side.
TEST(SpotGrid, OddPlacesOfARowLieFarthestOff) {
    std::vector<LitSpot> spots;
    std::vector<const LitSpot*> row;
    std::vector<double> along;
    for (const double y : {0.0, 0.1, -0.7, 0.0, 0.2, 0.9, 0.3, 0.0}) {
        along.push_back(5.0 * static_cast<double>(spots.size()));
        spots.push_back(spot_at({static_cast<double>(spots.size()), y}, 0));
    }
    for (const LitSpot& spot : spots) row.push_back(&spot);
    const SpotGrid grid(row, along);
    std::set<int> probed;
    for (const Pixel& p : grid.odd_places({0, 0, 7, 0})) probed.insert(p.x);
    EXPECT_EQ(probed, (std::set{2, 5}));
    EXPECT_EQ(grid.share({0, 0, 7, 0}, {3, 0}), Vec2(3.0 / 7, 0));
}
