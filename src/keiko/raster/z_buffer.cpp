#include "keiko/raster/z_buffer.h"

#include "keiko/base/parallel.h"
#include "keiko/raster/tile_items.h"

#include <array>
#include <limits>

namespace keiko {
namespace {

/// Depths and triangles of one tile.
class Tile {
public:
    explicit Tile(const PixelBox& box) : box_(box) {
        nearness_.fill(-std::numeric_limits<double>::infinity());
    }

    void add(const ScreenItem& item, ItemBuffer& seen) {
        scan_triangle(item.at, box_, [&](int x, int y, double nearness) {
            double& nearest = nearness_[static_cast<std::size_t>((y - box_.first_y) * tile_side +
                                                                 (x - box_.first_x))];
            if (!(nearness > nearest)) return;
            nearest = nearness;
            seen.shown[seen.index(x, y)] = item.triangle;
        });
    }

private:
    PixelBox box_;
    std::array<double, static_cast<std::size_t>(tile_side) * tile_side> nearness_;
};

} // namespace

ItemBuffer z_buffer(const SurfaceMesh& mesh, const Camera& camera, const Job& job) {
    const TileGrid grid{camera.width, camera.height};
    const TileItems items(screen_items(mesh, camera, job), grid, job);
    ItemBuffer seen(camera.width, camera.height);
    parallel_for(grid.count(), job, "", [&](std::size_t number) {
        Tile tile(grid.tile(number));
        items.each_item(number, [&](const ScreenItem& item) { tile.add(item, seen); });
    });
    return seen;
}

} // namespace keiko
