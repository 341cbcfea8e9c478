#include "keiko/render/lighting/lit_regions.h"

#include "keiko/math/bounds.h"
#include "keiko/math/disjoint_sets.h"

#include <algorithm>
#include <limits>

namespace keiko {
namespace {

/// Distances between normals count this much more than those between positions, from -1 to 1 in a
/// region: the light depends more on where a surface faces than on where it is.
constexpr double tilt_weight = 4;
/// Squared distances to preferred places count this much more.
constexpr double preference = 1.5;

/// Numbers of the places of each pixel of a tile.
class PlacesByPixel {
public:
    explicit PlacesByPixel(std::span<const LitPlace> places) {
        for (const LitPlace& place : places) {
            width_ = std::max(width_, place.pixel.x + 1);
            height_ = std::max(height_, place.pixel.y + 1);
        }
        pixels_.resize(index(0, height_));
        for (std::size_t i = 0; i < places.size(); ++i)
            pixels_[index(places[i].pixel.x, places[i].pixel.y)].push_back(i);
    }

    /// Calls `visit` with each pixel and itself, and with each pair of pixels side by side.
    template <class Visit>
    void each_pair(const Visit& visit) const {
        for (int y = 0; y < height_; ++y)
            for (int x = 0; x < width_; ++x) {
                const Places& here = pixels_[index(x, y)];
                visit(here, here);
                if (x + 1 < width_) visit(here, pixels_[index(x + 1, y)]);
                if (y + 1 < height_) visit(here, pixels_[index(x, y + 1)]);
            }
    }

private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x);
    }

    int width_ = 0, height_ = 0; ///< px
    std::vector<Places> pixels_;
};

/// Mean direction of the normals of a region, a unit vector.
Vec3 mean_normal(std::span<const LitPlace> places, const Places& region) {
    Vec3 sum(0);
    for (const std::size_t i : region) sum += places[i].point->place.normal;
    return sum.length() > 0 ? sum.normalized() : places[region[0]].point->place.normal;
}

/// Coordinates by which places of a region are near to each other.
using Coordinates = std::array<double, 5>;

Coordinates coordinates(const ChartPlace& place) {
    return {place.at.x, place.at.y, place.height, tilt_weight * place.tilt.x,
            tilt_weight * place.tilt.y};
}

double distance2(const ChartPlace& a, const ChartPlace& b) {
    const Coordinates from = coordinates(a), to = coordinates(b);
    double sum = 0;
    for (std::size_t i = 0; i < from.size(); ++i) sum += (to[i] - from[i]) * (to[i] - from[i]);
    return sum;
}

} // namespace

std::vector<Places> regions_of(std::span<const LitPlace> places,
                               const std::function<bool(std::size_t, std::size_t)>& alike) {
    DisjointSets sets(places.size());
    PlacesByPixel(places).each_pair([&](const Places& a, const Places& b) {
        for (const std::size_t i : a)
            for (const std::size_t j : b)
                if (sets.root(i) != sets.root(j) && alike(i, j)) sets.join(i, j);
    });
    std::vector<Places> of_root(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) of_root[sets.root(i)].push_back(i);
    std::erase_if(of_root, [](const Places& set) { return set.empty(); });
    return of_root;
}

std::vector<bool> beside_others(std::span<const LitPlace> places, std::span<const Places> regions) {
    std::vector<std::size_t> region_of(places.size());
    for (std::size_t r = 0; r < regions.size(); ++r)
        for (const std::size_t i : regions[r]) region_of[i] = r;
    std::vector<bool> beside(places.size());
    const auto look = [&](const Places& from, const Places& at) {
        for (const std::size_t i : from) {
            const auto is_own = [&](std::size_t j) { return region_of[j] == region_of[i]; };
            const bool others = &from == &at ? !std::all_of(at.begin(), at.end(), is_own)
                                             : std::none_of(at.begin(), at.end(), is_own);
            if (others && !at.empty()) beside[i] = true;
        }
    };
    PlacesByPixel(places).each_pair([&](const Places& a, const Places& b) {
        look(a, b);
        look(b, a);
    });
    return beside;
}

Chart chart_of(std::span<const LitPlace> places, const Places& region, bool tilted) {
    const Vec3 mean = mean_normal(places, region);
    const Vec3 beside = std::abs(mean.x) < 0.6 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    const Vec3 along = mean.cross(beside).normalized(), across = mean.cross(along);
    const auto turned = [&](const Vec3& w) {
        return Vec3(along.dot(w), across.dot(w), mean.dot(w));
    };
    std::vector<Vec3> positions;
    Box3 around;
    for (const std::size_t i : region) {
        positions.push_back(turned(places[i].point->place.position));
        around.extend(positions.back());
    }
    const Vec3 extent = around.extent();
    const double size = std::max({extent.x, extent.y, extent.z}) / 2;
    const double scale = size > 0 ? 1 / size : 1;
    Chart chart;
    for (std::size_t i = 0; i < region.size(); ++i) {
        const Vec3 at = (positions[i] - around.center()) * scale;
        const Vec3 normal = turned(places[region[i]].point->place.normal);
        chart.push_back({{at.x, at.y}, at.z, tilted ? Vec2(normal.x, normal.y) : Vec2(0)});
    }
    return chart;
}

std::array<Places, 2> halves(const Places& region, const Chart& chart) {
    Coordinates low = coordinates(chart[0]), high = low;
    for (const ChartPlace& place : chart) {
        const Coordinates here = coordinates(place);
        for (std::size_t i = 0; i < here.size(); ++i)
            low[i] = std::min(low[i], here[i]), high[i] = std::max(high[i], here[i]);
    }
    std::size_t widest = 0;
    for (std::size_t i = 1; i < low.size(); ++i)
        if (high[i] - low[i] > high[widest] - low[widest]) widest = i;
    const double middle = (low[widest] + high[widest]) / 2;
    std::array<Places, 2> halves;
    for (std::size_t i = 0; i < region.size(); ++i)
        halves[coordinates(chart[i])[widest] > middle ? 1 : 0].push_back(region[i]);
    return halves;
}

std::vector<std::size_t> spread_places(const Chart& chart, std::size_t count,
                                       const std::vector<bool>& preferred) {
    std::vector<double> apart(chart.size(), std::numeric_limits<double>::infinity());
    std::vector<std::size_t> chosen;
    while (chosen.size() < count) {
        std::size_t best = 0;
        double farthest = -1; // as of chosen ones
        for (std::size_t i = 0; i < chart.size(); ++i) {
            if (!chosen.empty())
                apart[i] = std::min(apart[i], distance2(chart[i], chart[chosen.back()]));
            const double worth = apart[i] * (preferred[i] ? preference : 1);
            if (worth > farthest) farthest = worth, best = i;
        }
        chosen.push_back(best);
        apart[best] = -1;
    }
    return chosen;
}

} // namespace keiko
