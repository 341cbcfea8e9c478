#pragma once

#include "keiko/base/job.h"
#include "keiko/base/parallel.h"
#include "keiko/raster/item_buffer.h"
#include "keiko/raster/screen_items.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace keiko {

/// The tiles of a picture, row by row. Their sides are powers of two, so that the tile of a pixel
/// is found by shifts.
struct TileGrid {
    int width = 0, height = 0; ///< pixels of the picture
    /// Binary logarithms of the pixels along the sides of a tile. Depths of a tile of 64 x 64 fit a
    /// processor's first cache.
    int width_bits = 6, height_bits = 6;
    int columns = ((width - 1) >> width_bits) + 1; ///< tiles in a row
    int rows = ((height - 1) >> height_bits) + 1;  ///< rows of tiles

    /// Number of tiles.
    std::size_t count() const {
        return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    }
    /// All pixels.
    PixelBox picture() const { return {0, 0, width - 1, height - 1}; }
    /// The pixels of a tile.
    PixelBox tile(std::size_t number) const {
        const int x = (static_cast<int>(number) % columns) << width_bits;
        const int y = (static_cast<int>(number) / columns) << height_bits;
        return PixelBox{x, y, x + (1 << width_bits) - 1, y + (1 << height_bits) - 1}.within(
            picture());
    }
    /// Calls `visit` for the numbers of the tiles that a box of pixels meets.
    template <class Visit>
    void each_tile(const PixelBox& box, const Visit& visit) const {
        for (int y = box.first_y >> height_bits; y <= box.last_y >> height_bits; ++y)
            for (int x = box.first_x >> width_bits; x <= box.last_x >> width_bits; ++x)
                visit(static_cast<std::size_t>(y * columns + x));
    }
};

/// Items of a picture sorted by the tiles that they meet.
class TileItems {
public:
    /// Sorts chunks side by side. Throws Cancelled.
    TileItems(ScreenItems items, const TileGrid& grid, const Job& job = {});

    /// Calls `visit` for the items that meet a tile, in the order of the mesh.
    template <class Visit>
    void each_item(std::size_t tile, const Visit& visit) const {
        for (const Chunk& chunk : chunks_)
            for (std::uint32_t i = chunk.begin[tile]; i < chunk.begin[tile + 1]; ++i)
                visit(chunk.items[chunk.of_tile[i]]);
    }

private:
    /// A chunk, and the numbers of its items tile by tile.
    struct Chunk {
        std::vector<ScreenItem> items;
        std::vector<std::uint32_t> begin; ///< a tile: its first in `of_tile`; one more
        std::vector<std::uint32_t> of_tile;
    };

    static Chunk sorted(std::vector<ScreenItem> items, const TileGrid& grid);

    std::vector<Chunk> chunks_;
};

/// Buffer of the triangles of a picture, found tile by tile on several threads.
/// `draw`(each_item, window, seen) writes the pixels of a tile; each_item(visit) calls `visit` for
/// the items that meet it, in the order of the mesh. Throws Cancelled.
template <class Draw>
ItemBuffer drawn_by_tiles(const SurfaceMesh& mesh, const Camera& camera, const TileGrid& grid,
                          const Job& job, const Draw& draw) {
    const TileItems items(screen_items(mesh, camera, job), grid, job);
    ItemBuffer seen(camera.width, camera.height);
    parallel_for(grid.count(), job, "", [&](std::size_t tile) {
        draw([&](const auto& visit) { items.each_item(tile, visit); }, grid.tile(tile), seen);
    });
    return seen;
}

} // namespace keiko
