#include "keiko/render/antialias/edge_pixel_lighting.h"

#include "keiko/math/bounds.h"
#include "keiko/render/lighting/light_interpolation.h"
#include "keiko/render/shading/mapped_paint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace keiko {
namespace {

using Spots = std::vector<OutlineSpot>;

constexpr double longest_row = 16; ///< px

Vec2 pixel_of(const OutlineSpot& point) {
    return Vec2(point.pixel.x, point.pixel.y);
}

/// Two shading points.
struct Ends {
    const OutlineSpot *first, *last;

    Vec2 way() const { return pixel_of(*last) - pixel_of(*first); }
};

/// Shading points whose pixels are farthest apart.
Ends ends_of(const Spots& points) {
    Ends ends{&points[0], &points[0]};
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = i + 1; j < points.size(); ++j) {
            const Ends others{&points[i], &points[j]};
            if (others.way().length2() > ends.way().length2()) ends = others;
        }
    return ends;
}

bool share_a_pixel(const Spots& points) {
    std::vector<std::pair<int, int>> pixels;
    for (const OutlineSpot& point : points) pixels.push_back({point.pixel.y, point.pixel.x});
    std::sort(pixels.begin(), pixels.end());
    return std::adjacent_find(pixels.begin(), pixels.end()) != pixels.end();
}

/// True if the points lie in a row. Each pixel occurs once, is at most two from the line from the
/// first to the last, and at most three from the one before. Other pieces of edges of one surface
/// may lie on the same line.
bool lie_in_a_row(const Spots& points, const Ends& ends) {
    if (share_a_pixel(points)) return false;
    const double length = ends.way().length();
    if (length > longest_row) return false;
    std::vector<double> along;
    for (const OutlineSpot& point : points) {
        const Vec2 off = pixel_of(point) - pixel_of(*ends.first);
        if (std::abs(ends.way().cross(off)) > 2 * length) return false;
        along.push_back(ends.way().dot(off));
    }
    std::sort(along.begin(), along.end());
    return std::adjacent_find(along.begin(), along.end(), [&](double a, double b) {
               return b - a > 3 * length;
           }) == along.end();
}

EdgeRun row_of(const Spots& points, const Ends& ends) {
    const Vec3 begin = ends.first->point->place.position;
    const Vec3 way = ends.last->point->place.position - begin;
    std::vector<std::pair<double, const ShadingPoint*>> places;
    for (const OutlineSpot& point : points)
        places.push_back({(point.point->place.position - begin).dot(way), point.point});
    std::stable_sort(places.begin(), places.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    EdgeRun row;
    for (const auto& [along, point] : places)
        row.along.push_back(along), row.points.push_back(point);
    return row;
}

/// Shading points on either side of the middle of the pixels' extent, across its longer side.
std::array<Spots, 2> halves(const Spots& points) {
    Box2 around;
    for (const OutlineSpot& point : points) around.extend(pixel_of(point));
    const int axis = around.extent().x < around.extent().y ? 1 : 0;
    std::array<Spots, 2> halves;
    for (const OutlineSpot& point : points)
        halves[pixel_of(point)[axis] > around.center()[axis] ? 1 : 0].push_back(point);
    return halves;
}

void add_rows(const Spots& points, std::vector<EdgeRun>& rows) {
    for (const Spots& surface : smooth_surfaces(points)) {
        const Ends ends = ends_of(surface);
        if (lie_in_a_row(surface, ends)) {
            rows.push_back(row_of(surface, ends));
            continue;
        }
        const auto [low, high] = halves(surface);
        if (high.empty()) {
            for (const OutlineSpot& point : surface) rows.push_back({{point.point}, {0}});
        } else {
            add_rows(low, rows);
            add_rows(high, rows);
        }
    }
}

} // namespace

std::vector<Spots> smooth_surfaces(Spots points) {
    std::vector<Spots> surfaces;
    while (!points.empty()) {
        Spots surface{points[0]}, rest(points.begin() + 1, points.end());
        for (std::size_t i = 0; i < surface.size(); ++i) {
            const SurfacePlace place = surface[i].point->place;
            const auto joins = [&](const OutlineSpot& o) {
                return is_same_surface(place, o.point->place);
            };
            const auto others = std::stable_partition(rest.begin(), rest.end(), joins);
            surface.insert(surface.end(), rest.begin(), others);
            rest.erase(rest.begin(), others);
        }
        surfaces.push_back(std::move(surface));
        points = std::move(rest);
    }
    return surfaces;
}

std::vector<EdgeRun> edge_runs(const Spots& points) {
    std::vector<EdgeRun> rows;
    add_rows(points, rows);
    return rows;
}

namespace {

/// The point of a surface nearest to the mean place of all, by the shares of their parts.
OutlineSpot amid(const Spots& surface, const std::vector<Subpixel>& parts) {
    const auto share = [&](const OutlineSpot& spot) { return parts[spot.point->sample].share; };
    Vec3 sum(0);
    double shares = 0;
    for (const OutlineSpot& spot : surface) {
        sum += spot.point->place.position * share(spot);
        shares += share(spot);
    }
    const Vec3 mean = sum / shares;
    const auto off = [&](const OutlineSpot& spot) {
        return (spot.point->place.position - mean).length2();
    };
    return *std::min_element(surface.begin(), surface.end(),
                             [&](const auto& a, const auto& b) { return off(a) < off(b); });
}

/// Sorts shading points by branch, then by pixel and part.
void sort_by_pixel(RefinedPixels& refined) {
    const auto order = [&](const ShadingPoint& point) {
        return std::tuple(point.branch, refined.parts[point.sample].pixel, point.sample);
    };
    std::stable_sort(
        refined.points.begin(), refined.points.end(),
        [&](const ShadingPoint& a, const ShadingPoint& b) { return order(a) < order(b); });
}

/// Lights shared places of one branch along rows of them.
void light_rows(const Integrator& integrator, std::span<const SharedPlace> places, double error,
                std::vector<Subpixel>& parts) {
    Spots spots;
    std::map<const ShadingPoint*, const SharedPlace*> by_point;
    for (const SharedPlace& place : places) {
        spots.push_back(place.lit);
        by_point[place.lit.point] = &place;
    }
    for (const EdgeRun& row : edge_runs(spots)) {
        const ShadingGrid grid(row.points, row.along);
        std::vector<Rgb> seen;
        for (const ShadingPoint* point : row.points)
            seen.push_back(parts[point->sample].sample.luminance);
        const std::vector<DirectLight> light =
            light_interpolation(integrator, grid, seen, {}, error);
        for (std::size_t i = 0; i < light.size(); ++i)
            for (const OutlineSpot& spot : by_point.at(row.points[i])->points)
                integrator.add_light(*spot.point, light[i], parts[spot.point->sample].sample);
    }
}

} // namespace

std::vector<SharedPlace> shared_places(int width, RefinedPixels& refined) {
    sort_by_pixel(refined);
    const std::vector<ShadingPoint>& points = refined.points;
    const auto pixel = [&](const ShadingPoint& point) { return refined.parts[point.sample].pixel; };
    const auto w = static_cast<std::size_t>(width);
    std::vector<SharedPlace> places;
    for (std::size_t i = 0; i < points.size();) {
        const std::size_t number = pixel(points[i]);
        const std::uint64_t branch = points[i].branch;
        const Pixel at{static_cast<int>(number % w), static_cast<int>(number / w)};
        Spots of_pixel;
        for (; i < points.size() && pixel(points[i]) == number && points[i].branch == branch; ++i)
            of_pixel.push_back({at, &points[i]});
        const auto uneven = [](const OutlineSpot& spot) { return is_uneven(*spot.point); };
        if (std::any_of(of_pixel.begin(), of_pixel.end(), uneven)) {
            for (const OutlineSpot& spot : of_pixel) places.push_back({spot, {spot}});
            continue;
        }
        for (Spots& surface : smooth_surfaces(std::move(of_pixel)))
            places.push_back({amid(surface, refined.parts), std::move(surface)});
    }
    return places;
}

void add_shared_light(const Integrator& integrator, int width, double error,
                      RefinedPixels& refined) {
    const std::vector<SharedPlace> places = shared_places(width, refined);
    std::span<const SharedPlace> left = places;
    while (!left.empty()) {
        const std::uint64_t branch = left[0].lit.point->branch;
        const auto further = std::find_if(left.begin(), left.end(), [&](const SharedPlace& place) {
            return place.lit.point->branch != branch;
        });
        const auto count = static_cast<std::size_t>(further - left.begin());
        light_rows(integrator, left.first(count), error, refined.parts);
        left = left.subspan(count);
    }
}

} // namespace keiko
