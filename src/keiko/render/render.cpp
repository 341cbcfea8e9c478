#include "keiko/base/log.h"
#include "keiko/base/parallel.h"
#include "keiko/render/antialias/edge_detection.h"
#include "keiko/render/antialias/edge_refinement.h"
#include "keiko/render/antialias/tile_lighting.h"
#include "keiko/render/tiles.h"

#include <optional>
#include <utility>

namespace keiko {
namespace {

/// Pixels a side of a tile; one thread renders it.
constexpr int tile_size = 64;

/// The pixels of a tile that may contain edges, with the samples of their centres unless they are
/// discontinuous.
std::vector<EdgeCell> outlined_cells(const Tile& tile, std::span<const Outline> outlines,
                                     std::span<const PixelSample> samples) {
    const auto width = static_cast<std::size_t>(tile.width());
    std::vector<EdgeCell> cells;
    for (std::size_t pixel = 0; pixel < outlines.size(); ++pixel) {
        const Outline outline = outlines[pixel];
        if (outline == Outline::none) continue;
        const std::size_t x = pixel % width, y = pixel / width;
        const std::size_t place = (y + 1) * (width + 2) + x + 1; // the view is one pixel wider
        const Vec2 at(tile.x0 + static_cast<double>(x), tile.y0 + static_cast<double>(y));
        cells.push_back(
            {pixel, at, Vec2(1), outline == Outline::discontinuous ? nullptr : &samples[place]});
    }
    return cells;
}

/// Replaces the luminance of pixels by the mean over their parts.
void write_parts(const RefinedPixels& refined, const Tile& tile, Film& film) {
    const auto width = static_cast<std::size_t>(tile.width());
    std::vector<PixelSample> samples;
    std::vector<double> shares;
    const std::vector<Subpixel>& parts = refined.parts;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        samples.push_back(parts[i].sample), shares.push_back(parts[i].share);
        const std::size_t pixel = parts[i].pixel;
        if (i + 1 < parts.size() && parts[i + 1].pixel == pixel) continue;
        write_mean(film, tile.x0 + static_cast<int>(pixel % width),
                   tile.y0 + static_cast<int>(pixel / width), samples, shares);
        samples.clear(), shares.clear();
    }
}

RefinedPixels refine_outlines(const Integrator& integrator, const PictureRays& eye,
                              const Tile& tile, int edge_samples, const SampleBatch& view) {
    if (edge_samples == 1) return {};
    const std::vector<Outline> outlines = outlines_of(view.samples, tile.width() + 2);
    return refined_pixels(integrator, eye.camera, outlined_cells(tile, outlines, view.samples),
                          1.0 / edge_samples);
}

/// Renders a tile. Neighbours beyond it determine where edges are and how the images of pixels are
/// bent.
HitStatistics render_tile(const Integrator& integrator, const PictureRays& eye, const Tile& tile,
                          const PictureOptions& options, Film& film) {
    const TileRays grid = grid_of(eye, tile);
    if (grid.places.empty()) {
        write_unseen(integrator, tile, film);
        return {};
    }
    SampleBatch view = integrator.view(grid);
    RefinedPixels refined = refine_outlines(integrator, eye, tile, options.edge_samples, view);
    view = without_border(std::move(view), tile.width() + 2); // which shows the neighbours
    add_tile_light(integrator, tile.width(), options.light_error, view, refined);
    HitStatistics paths = write_samples(view.samples, tile, film);
    write_parts(refined, tile, film);
    paths += refined.paths;
    return paths;
}

} // namespace

Film render(const PictureScene& scene, const Camera& camera, const PictureOptions& options,
            const Job& job) {
    Film film = blank_film(camera.width, camera.height, options.aovs);
    const bool from_eye = camera.projection == Projection::perspective;
    const Integrator integrator(scene, options, from_eye ? std::optional(camera.eye) : std::nullopt,
                                job);
    const PictureRays eye(scene, camera);
    const std::vector<Tile> tiles = tiles_of(camera, tile_size, tile_size);
    std::vector<HitStatistics> paths(tiles.size());
    parallel_for(tiles.size(), job, "render", [&](std::size_t i) {
        paths[i] = render_tile(integrator, eye, tiles[i], options, film);
    });
    HitStatistics sum;
    for (const HitStatistics& tile : paths) sum += tile;
    log_detail("picture of " + path_text(sum));
    return film;
}

} // namespace keiko
