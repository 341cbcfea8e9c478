#include "keiko/render/antialias/outline_rows.h"

#include "keiko/math/bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace keiko {
namespace {

using Spots = std::vector<OutlineSpot>;

constexpr double longest_row = 16; ///< px

Vec2 pixel_of(const OutlineSpot& spot) {
    return Vec2(spot.pixel.x, spot.pixel.y);
}

/// Two spots.
struct Ends {
    const OutlineSpot *first, *last;

    Vec2 way() const { return pixel_of(*last) - pixel_of(*first); }
};

/// Those whose pixels are farthest apart.
Ends ends_of(const Spots& spots) {
    Ends ends{&spots[0], &spots[0]};
    for (std::size_t i = 0; i < spots.size(); ++i)
        for (std::size_t j = i + 1; j < spots.size(); ++j) {
            const Ends others{&spots[i], &spots[j]};
            if (others.way().length2() > ends.way().length2()) ends = others;
        }
    return ends;
}

bool share_a_pixel(const Spots& spots) {
    std::vector<std::pair<int, int>> pixels;
    for (const OutlineSpot& spot : spots) pixels.push_back({spot.pixel.y, spot.pixel.x});
    std::sort(pixels.begin(), pixels.end());
    return std::adjacent_find(pixels.begin(), pixels.end()) != pixels.end();
}

/// Each pixel but once, at most two off the line from the first to the last, and three on from the
/// one before: other pieces of outlines of one surface may lie on the same line.
bool lie_in_a_row(const Spots& spots, const Ends& ends) {
    if (share_a_pixel(spots)) return false;
    const double length = ends.way().length();
    if (length > longest_row) return false;
    std::vector<double> along;
    for (const OutlineSpot& spot : spots) {
        const Vec2 off = pixel_of(spot) - pixel_of(*ends.first);
        if (std::abs(ends.way().cross(off)) > 2 * length) return false;
        along.push_back(ends.way().dot(off));
    }
    std::sort(along.begin(), along.end());
    return std::adjacent_find(along.begin(), along.end(), [&](double a, double b) {
               return b - a > 3 * length;
           }) == along.end();
}

OutlineRow row_of(const Spots& spots, const Ends& ends) {
    const Vec3 begin = ends.first->spot->place.position;
    const Vec3 way = ends.last->spot->place.position - begin;
    std::vector<std::pair<double, const LitSpot*>> places;
    for (const OutlineSpot& spot : spots)
        places.push_back({(spot.spot->place.position - begin).dot(way), spot.spot});
    std::stable_sort(places.begin(), places.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    OutlineRow row;
    for (const auto& [along, spot] : places) row.along.push_back(along), row.spots.push_back(spot);
    return row;
}

/// Those on either side of the middle of the pixels' extent, across its longer side.
std::array<Spots, 2> halves(const Spots& spots) {
    Box2 around;
    for (const OutlineSpot& spot : spots) around.extend(pixel_of(spot));
    const int axis = around.extent().x < around.extent().y ? 1 : 0;
    std::array<Spots, 2> halves;
    for (const OutlineSpot& spot : spots)
        halves[pixel_of(spot)[axis] > around.center()[axis] ? 1 : 0].push_back(spot);
    return halves;
}

void add_rows(const Spots& spots, std::vector<OutlineRow>& rows) {
    for (const Spots& surface : smooth_surfaces(spots)) {
        const Ends ends = ends_of(surface);
        if (lie_in_a_row(surface, ends)) {
            rows.push_back(row_of(surface, ends));
            continue;
        }
        const auto [low, high] = halves(surface);
        if (high.empty()) {
            for (const OutlineSpot& spot : surface) rows.push_back({{spot.spot}, {0}});
        } else {
            add_rows(low, rows);
            add_rows(high, rows);
        }
    }
}

} // namespace

std::vector<Spots> smooth_surfaces(Spots spots) {
    std::vector<Spots> surfaces;
    while (!spots.empty()) {
        Spots surface{spots[0]}, rest(spots.begin() + 1, spots.end());
        for (std::size_t i = 0; i < surface.size(); ++i) {
            const SurfacePlace place = surface[i].spot->place;
            const auto joins = [&](const OutlineSpot& o) {
                return continues(place, o.spot->place);
            };
            const auto others = std::stable_partition(rest.begin(), rest.end(), joins);
            surface.insert(surface.end(), rest.begin(), others);
            rest.erase(rest.begin(), others);
        }
        surfaces.push_back(std::move(surface));
        spots = std::move(rest);
    }
    return surfaces;
}

std::vector<OutlineRow> outline_rows(const Spots& spots) {
    std::vector<OutlineRow> rows;
    add_rows(spots, rows);
    return rows;
}

} // namespace keiko
