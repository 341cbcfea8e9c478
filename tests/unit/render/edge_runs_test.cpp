#include "keiko/render/antialias/edge_pixel_lighting.h"
#include "keiko/render/lighting/shading_grid.h"

#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

using namespace keiko;

namespace {

/// A shading point of a plane at a height in which pixels are 5 mm wide.
ShadingPoint shading_point_at(const Vec2& place, double height) {
    ShadingPoint point;
    point.place = {Vec3(5 * place.x, 5 * place.y, height), Vec3(0, 0, 1), 0};
    return point;
}

std::vector<OutlineSpot> of(const std::vector<Pixel>& pixels,
                            const std::vector<ShadingPoint>& points) {
    std::vector<OutlineSpot> outline;
    for (std::size_t i = 0; i < pixels.size(); ++i) outline.push_back({pixels[i], &points[i]});
    return outline;
}

/// Expects the properties of a row: along one line of the picture without gaps, and in order along
/// the surface.
void expect_row(const EdgeRun& row, const std::map<const ShadingPoint*, Pixel>& pixel_of) {
    ASSERT_EQ(row.points.size(), row.along.size());
    EXPECT_TRUE(std::is_sorted(row.along.begin(), row.along.end()));
    std::vector<Vec2> places;
    for (const ShadingPoint* point : row.points)
        places.push_back(Vec2(pixel_of.at(point).x, pixel_of.at(point).y));
    std::sort(places.begin(), places.end(), [](const Vec2& a, const Vec2& b) { return a.x < b.x; });
    const Vec2 way = places.back() - places.front();
    EXPECT_LE(way.length(), 16);
    for (std::size_t i = 0; i < places.size(); ++i) {
        EXPECT_LE(std::abs(way.cross(places[i] - places[0])), 2 * way.length());
        if (i > 0) {
            EXPECT_LE(places[i].x - places[i - 1].x, 3);
        }
    }
}

} // namespace

// Along a wave every pixel is in one row, and rows are long where the wave is straight.
TEST(OutlineRows, HoldEachPixelOfAWaveOnce) {
    test::Random random(5);
    std::vector<Pixel> pixels;
    std::vector<ShadingPoint> points;
    for (int x = 0; x < 64; ++x) {
        const double y = 30 + 12 * std::sin(x / 9.0);
        pixels.push_back({x, static_cast<int>(y)});
        points.push_back(shading_point_at({x + test::uniform(random, 0, 1), y}, 0));
    }
    std::map<const ShadingPoint*, Pixel> pixel_of;
    for (std::size_t i = 0; i < points.size(); ++i) pixel_of[&points[i]] = pixels[i];
    const std::vector<EdgeRun> rows = edge_runs(of(pixels, points));
    std::multiset<const ShadingPoint*> all;
    for (const EdgeRun& row : rows) {
        expect_row(row, pixel_of);
        all.insert(row.points.begin(), row.points.end());
    }
    EXPECT_EQ(all.size(), points.size());
    EXPECT_EQ(std::set(all.begin(), all.end()).size(), points.size());
    EXPECT_GT(rows.size(), 3u);
    EXPECT_LT(rows.size(), 12u);
}

// The rims of two holes on one line: shadows may fall on one alone.
TEST(OutlineRows, EndWhereOutlinesDo) {
    std::vector<Pixel> pixels;
    std::vector<ShadingPoint> points;
    for (const int x : {0, 1, 2, 3, 9, 10, 11, 12}) {
        pixels.push_back({x, 3});
        points.push_back(shading_point_at({x + 0.5, 3.5}, 0));
    }
    const std::vector<EdgeRun> rows = edge_runs(of(pixels, points));
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0].points.size(), 4u);
    EXPECT_EQ(rows[1].points.size(), 4u);
}

// Two planes a step apart show in the same pixels: their shading points never come to one row.
TEST(OutlineRows, AreOfOneSurface) {
    std::vector<Pixel> pixels;
    std::vector<ShadingPoint> points;
    for (int x = 0; x < 16; ++x)
        for (const double height : {0.0, 400.0}) {
            pixels.push_back({x, 3});
            points.push_back(shading_point_at({x + 0.5, 3.5}, height));
        }
    const std::vector<EdgeRun> rows = edge_runs(of(pixels, points));
    ASSERT_EQ(rows.size(), 2u);
    for (const EdgeRun& row : rows) {
        ASSERT_EQ(row.points.size(), 16u);
        for (const ShadingPoint* point : row.points)
            EXPECT_EQ(point->place.position.z, row.points[0]->place.position.z);
    }
}

// Two places of one surface in each pixel, as beside a thin bar: no row holds a pixel twice.
TEST(OutlineRows, HoldNoPixelTwice) {
    std::vector<Pixel> pixels;
    std::vector<ShadingPoint> points;
    for (int x = 0; x < 8; ++x)
        for (const double y : {3.1, 3.9}) {
            pixels.push_back({x, 3});
            points.push_back(shading_point_at({x + 0.5, y}, 0));
        }
    std::size_t count = 0;
    for (const EdgeRun& row : edge_runs(of(pixels, points))) {
        EXPECT_EQ(row.points.size(), 1u);
        count += row.points.size();
    }
    EXPECT_EQ(count, points.size());
}

// What is tested of a row besides its middle are the places farthest off on either side.
TEST(ShadingGrid, OddPlacesOfARowLieFarthestOff) {
    std::vector<ShadingPoint> points;
    std::vector<const ShadingPoint*> row;
    std::vector<double> along;
    for (const double y : {0.0, 0.1, -0.7, 0.0, 0.2, 0.9, 0.3, 0.0}) {
        along.push_back(5.0 * static_cast<double>(points.size()));
        points.push_back(shading_point_at({static_cast<double>(points.size()), y}, 0));
    }
    for (const ShadingPoint& point : points) row.push_back(&point);
    const ShadingGrid grid(row, along);
    std::set<int> probed;
    for (const Pixel& p : grid.odd_places({0, 0, 7, 0})) probed.insert(p.x);
    EXPECT_EQ(probed, (std::set{2, 5}));
    EXPECT_EQ(grid.share({0, 0, 7, 0}, {3, 0}), Vec2(3.0 / 7, 0));
}

// A shadow of five places meets one that is sampled, wherever it falls.
TEST(ShadingGrid, LeavesNoMoreThanFourPlacesOfAStraightRowUnseen) {
    std::vector<ShadingPoint> points;
    for (int x = 0; x < 17; ++x) points.push_back(shading_point_at({x + 0.5, 0.5}, 0));
    for (int longest = 2; longest <= 16; ++longest) {
        std::vector<const ShadingPoint*> row;
        std::vector<double> along;
        for (int x = 0; x <= longest; ++x)
            row.push_back(&points[static_cast<std::size_t>(x)]), along.push_back(x);
        const Rectangle r{0, 0, longest, 0};
        std::set<int> seen{0, longest, r.middle().x};
        for (const Pixel& p : ShadingGrid(row, along).odd_places(r)) seen.insert(p.x);
        int last = 0;
        for (const int x : seen) {
            EXPECT_LE(x - last - 1, 4) << longest;
            last = x;
        }
    }
}
