#include "keiko/render/lighting/shading_grid.h"

#include "keiko/render/shading/mapped_paint.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

namespace keiko {
namespace {

std::vector<const SurfacePlace*> places_of(std::span<const ShadingPoint* const> points) {
    std::vector<const SurfacePlace*> places(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        if (points[i]) places[i] = &points[i]->place;
    return places;
}

double share_of_way(double begin, double end, double at) {
    return end > begin ? (at - begin) / (end - begin) : 0;
}

} // namespace

ShadingGrid::ShadingGrid(int width, int height, std::span<const ShadingPoint> points,
                         std::size_t first_sample)
    : width_(width),
      height_(height),
      spots_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)),
      along_(static_cast<std::size_t>(width)) {
    for (const ShadingPoint& point : points) spots_[point.sample - first_sample] = &point;
    std::iota(along_.begin(), along_.end(), 0.0);
    joins_ = SurfaceContinuity(width, places_of(spots_));
}

ShadingGrid::ShadingGrid(std::vector<const ShadingPoint*> row, std::vector<double> along)
    : width_(static_cast<int>(row.size())),
      height_(1),
      spots_(std::move(row)),
      along_(std::move(along)),
      joins_(width_, places_of(spots_)) {}

Vec2 ShadingGrid::share(const Rectangle& r, const Pixel& p) const {
    const auto along = [&](int x) { return along_[static_cast<std::size_t>(x)]; };
    return {share_of_way(along(r.x0), along(r.x1), along(p.x)), share_of_way(r.y0, r.y1, p.y)};
}

std::vector<Pixel> ShadingGrid::odd_places(const Rectangle& r) const {
    return height_ > 1 ? r.odd_places() : odd_places_of_row(r);
}

std::vector<Pixel> ShadingGrid::odd_places_of_row(const Rectangle& r) const {
    const auto& [first, normal, paint] = at(r.x0, 0)->place;
    const Vec3 across = normal.cross(at(r.x1, 0)->place.position - first);
    std::pair low{0.0, r.x0}, high{0.0, r.x0};
    for (int x = r.x0 + 1; x < r.x1; ++x) {
        const std::pair off{across.dot(at(x, 0)->place.position - first), x};
        low = std::min(low, off), high = std::max(high, off);
    }
    std::set<int> columns{low.second, high.second};
    if (r.longest() >= 6) columns.insert(r.x1 - (r.longest() < 12 ? 2 : 4));
    if (r.longest() >= 12) columns.insert(r.x0 + 3);
    std::vector<Pixel> odd;
    for (const int x : columns)
        if (x != r.x0 && x != r.middle().x) odd.push_back({x, 0});
    return odd;
}

bool ShadingGrid::is_smooth(int x0, int y0, int x1, int y1) const {
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x) {
            if (!at(x, y) || is_uneven(*at(x, y))) return false;
            if (x < x1 && !goes_right(x, y)) return false;
            if (y < y1 && !goes_down(x, y)) return false;
        }
    return true;
}

} // namespace keiko
