#include "keiko/render/tiles.h"

#include "keiko/render/pixel_writer.h"
#include "keiko/render/reflection/hilbert_order.h"

#include <algorithm>

namespace keiko {

std::vector<Tile> tiles_of(const Camera& camera, int width, int height) {
    std::vector<Tile> tiles;
    for (int y = 0; y < camera.height; y += height)
        for (int x = 0; x < camera.width; x += width)
            tiles.push_back(
                {x, y, std::min(x + width, camera.width), std::min(y + height, camera.height)});
    return tiles;
}

PictureRays::PictureRays(const PictureScene& scene, const Camera& seen_by) : camera(seen_by) {
    // Where there is a medium, rays that meet nothing see it too.
    if (!scene.rig.medium) cover.emplace(seen_by, scene.tracer.boxes());
}

TileRays grid_of(const PictureRays& eye, const Tile& tile) {
    const int left = tile.x0 - 1, top = tile.y0 - 1;
    TileRays grid;
    grid.width = tile.width() + 2, grid.height = tile.height() + 2;
    const auto& order = hilbert_order(grid.width, grid.height);
    grid.places.reserve(order.size());
    for (const GridPlace& place : order)
        if (eye.may_meet(left + place.x, top + place.y)) grid.places.push_back(place);
    grid.rays = [&eye, left, top](std::span<const GridPlace> places) {
        std::vector<Vec2> points;
        points.reserve(places.size());
        for (const GridPlace& place : places)
            points.emplace_back(left + place.x + 0.5, top + place.y + 0.5);
        return eye.camera.rays(points);
    };
    return grid;
}

HitStatistics write_samples(std::span<const PixelSample> samples, int border, const Tile& tile,
                            Film& film) {
    const auto width = static_cast<std::size_t>(tile.width()),
               beside = static_cast<std::size_t>(border), stride = width + 2 * beside;
    HitStatistics paths;
    for (int y = tile.y0; y < tile.y1; ++y) {
        const std::size_t row = static_cast<std::size_t>(y - tile.y0 + border);
        const auto pixels = samples.subspan(row * stride + beside, width);
        for (const PixelSample& sample : pixels) paths += sample.paths;
        write_row(film, tile.x0, y, pixels);
    }
    return paths;
}

void write_unseen(const Integrator& integrator, const Tile& tile, Film& film) {
    const std::vector<PixelSample> row(static_cast<std::size_t>(tile.width()), integrator.unseen());
    for (int y = tile.y0; y < tile.y1; ++y) write_row(film, tile.x0, y, row);
}

} // namespace keiko
