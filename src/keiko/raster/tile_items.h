#pragma once

#include "keiko/base/job.h"
#include "keiko/raster/screen_items.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace keiko {

/// Pixels along a side of a tile: depths of a tile fit a processor's first cache.
constexpr int tile_side = 64;

/// The tiles of a picture, row by row.
struct TileGrid {
    int width = 0, height = 0;                         ///< pixels of the picture
    int columns = (width + tile_side - 1) / tile_side; ///< tiles in a row
    int rows = (height + tile_side - 1) / tile_side;   ///< rows of tiles

    /// Number of tiles.
    std::size_t count() const {
        return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    }
    /// All pixels.
    PixelBox picture() const { return {0, 0, width - 1, height - 1}; }
    /// The pixels of a tile.
    PixelBox tile(std::size_t number) const {
        const int x = static_cast<int>(number) % columns * tile_side;
        const int y = static_cast<int>(number) / columns * tile_side;
        return PixelBox{x, y, x + tile_side - 1, y + tile_side - 1}.within(picture());
    }
    /// Calls `visit` for the numbers of the tiles that a box of pixels meets.
    template <class Visit>
    void each_tile(const PixelBox& box, const Visit& visit) const {
        for (int y = box.first_y / tile_side; y <= box.last_y / tile_side; ++y)
            for (int x = box.first_x / tile_side; x <= box.last_x / tile_side; ++x)
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

} // namespace keiko
