#include "keiko/raster/tile_items.h"

#include "keiko/base/parallel.h"

#include <utility>

namespace keiko {
namespace {

PixelBox box_of(const ScreenItem& item, const TileGrid& grid) {
    return pixels_of(item.at).within(grid.picture());
}

} // namespace

TileItems::TileItems(ScreenItems items, const TileGrid& grid, const Job& job)
    : chunks_(items.size()) {
    parallel_for(items.size(), job, "",
                 [&](std::size_t c) { chunks_[c] = sorted(std::move(items[c]), grid); });
}

TileItems::Chunk TileItems::sorted(std::vector<ScreenItem> items, const TileGrid& grid) {
    Chunk chunk{std::move(items), std::vector<std::uint32_t>(grid.count() + 1), {}};
    for (const ScreenItem& item : chunk.items)
        grid.each_tile(box_of(item, grid), [&](std::size_t tile) { ++chunk.begin[tile + 1]; });
    for (std::size_t tile = 0; tile < grid.count(); ++tile)
        chunk.begin[tile + 1] += chunk.begin[tile];
    chunk.of_tile.resize(chunk.begin.back());
    std::vector<std::uint32_t> next(chunk.begin.begin(), chunk.begin.end() - 1);
    for (std::uint32_t i = 0; i < chunk.items.size(); ++i)
        grid.each_tile(box_of(chunk.items[i], grid),
                       [&](std::size_t tile) { chunk.of_tile[next[tile]++] = i; });
    return chunk;
}

} // namespace keiko
