#include "keiko/render/tiles.h"

#include <algorithm>
#include <optional>

namespace keiko {
namespace {

/// Rows of a band that are traced together: few enough for their data to stay in the processor's
/// cache. With those around them they are as many as a Hilbert curve's square has.
constexpr int rows_at_once = 14;
constexpr int band_width = 126, most_rows = 10 * rows_at_once;
/// Least number of bands a thread, for the wait for the last one to be short.
constexpr std::size_t least_bands = 32;

/// Removes the traced rows from a grid that continues another.
void leave_out_seen_rows(TileRays& grid) {
    std::erase_if(grid.places, [](const GridPlace& place) { return place.y < 2; });
    grid.continues_above = true;
}

} // namespace

std::vector<Tile> picture_bands(const Camera& camera, std::size_t threads) {
    for (int rows = most_rows; rows > rows_at_once; rows -= rows_at_once)
        if (auto bands = tiles_of(camera, band_width, rows); bands.size() >= least_bands * threads)
            return bands;
    return tiles_of(camera, band_width, rows_at_once);
}

HitStatistics render_band(const Integrator& integrator, const PictureRays& eye, const Tile& band,
                          Film& film) {
    std::optional<EyeBand> seen;
    HitStatistics paths;
    for (int y = band.y0; y < band.y1; y += rows_at_once) {
        const Tile rows{band.x0, y, band.x1, std::min(y + rows_at_once, band.y1)};
        TileRays grid = grid_of(eye, rows);
        if (grid.places.empty()) {
            write_unseen(integrator, rows, film);
            seen.reset();
            continue;
        }
        grid.continues_below = rows.y1 < band.y1;
        if (seen)
            leave_out_seen_rows(grid);
        else
            seen.emplace(grid.width, grid.height);
        integrator.trace_tile(grid, *seen);
        paths += write_samples(seen->view.samples, 1, rows, film);
    }
    return paths;
}

} // namespace keiko
