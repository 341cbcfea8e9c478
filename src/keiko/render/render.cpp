#include "keiko/base/log.h"
#include "keiko/base/parallel.h"
#include "keiko/render/interpolated_light.h"
#include "keiko/render/outlines.h"
#include "keiko/render/pixel_writer.h"
#include "keiko/render/shared_light.h"

#include <algorithm>
#include <optional>

namespace keiko {
namespace {

constexpr int tile_size = 32;

/// A square piece of the picture, rendered by one thread.
struct Tile {
    int x0, y0, x1, y1;
};

std::vector<Tile> tiles_of(const Camera& camera) {
    std::vector<Tile> tiles;
    for (int y = 0; y < camera.height; y += tile_size)
        for (int x = 0; x < camera.width; x += tile_size)
            tiles.push_back({x, y, std::min(x + tile_size, camera.width),
                             std::min(y + tile_size, camera.height)});
    return tiles;
}

template <class F>
void for_each_pixel(const Tile& tile, const F& visit) {
    for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; ++x) visit(x, y);
}

/// The centres of a pixel's n x n cells as eye rays, each with the footprint of its cell.
void append_cell_rays(const Camera& camera, int x, int y, int n, std::vector<Ray>& rays) {
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            Ray ray = camera.ray(x + (i + 0.5) / n, y + (j + 0.5) / n);
            ray.differentials = ray.differentials->scaled(1.0 / n);
            rays.push_back(ray);
        }
}

PathCounts paths_of(std::span<const EyeSample> samples) {
    PathCounts counts;
    for (const EyeSample& sample : samples) counts += sample.paths;
    return counts;
}

/// One ray a pixel, those of `outlined` pixels without the light of spots.
PathCounts render_centres(const Integrator& integrator, const Tile& tile, double light_error,
                          const std::vector<bool>& outlined, EyeView view, Film& film) {
    add_interpolated_light(integrator, tile.x1 - tile.x0, outlined, light_error, view);
    auto sample = view.samples.begin();
    for_each_pixel(tile, [&](int x, int y) { write_pixel(film, x, y, *sample++); });
    return paths_of(view.samples);
}

/// Replaces the luminance of the pixels that hold an outline by the mean over their cells.
PathCounts refine_outlines(const Integrator& integrator, const Camera& camera, const Tile& tile,
                           int n, const std::vector<bool>& outlined, Film& film) {
    std::vector<Ray> rays;
    auto crossed = outlined.begin();
    for_each_pixel(tile, [&](int x, int y) {
        if (*crossed++) append_cell_rays(camera, x, y, n, rays);
    });
    EyeView view = integrator.view(rays);
    add_shared_light(integrator, n, view);
    const auto cells = static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
    std::span<const EyeSample> rest(view.samples);
    crossed = outlined.begin();
    for_each_pixel(tile, [&](int x, int y) {
        if (!*crossed++) return;
        write_mean(film, x, y, rest.first(cells));
        rest = rest.subspan(cells);
    });
    return paths_of(view.samples);
}

/// Neighbours beyond the tile tell where outlines are and how the images of pixels are bent.
PathCounts render_tile(const Integrator& integrator, const Camera& camera, const Tile& tile,
                       const PictureOptions& options, Film& film) {
    const int width = tile.x1 - tile.x0 + 2;
    const Tile bordered{tile.x0 - 1, tile.y0 - 1, tile.x1 + 1, tile.y1 + 1};
    std::vector<Ray> rays;
    for_each_pixel(bordered, [&](int x, int y) { append_cell_rays(camera, x, y, 1, rays); });
    const EyeView view = integrator.view(rays, width);
    const bool refines = options.edge_samples > 1;
    const std::vector<bool> outlined =
        refines ? outlined_pixels(view.samples, width) : std::vector<bool>(view.samples.size());
    PathCounts paths = render_centres(integrator, tile, options.light_error, outlined,
                                      without_border(view, width), film);
    if (refines)
        paths += refine_outlines(integrator, camera, tile, options.edge_samples, outlined, film);
    return paths;
}

} // namespace

Film render(const PictureScene& scene, const Camera& camera, const PictureOptions& options,
            const Job& job) {
    Film film = blank_film(camera.width, camera.height, options.aovs);
    const bool from_eye = camera.projection == Projection::perspective;
    const Integrator integrator(scene, options, from_eye ? std::optional(camera.eye) : std::nullopt,
                                job);
    const std::vector<Tile> tiles = tiles_of(camera);
    std::vector<PathCounts> paths(tiles.size());
    parallel_for(tiles.size(), job, "render", [&](std::size_t i) {
        paths[i] = render_tile(integrator, camera, tiles[i], options, film);
    });
    PathCounts sum;
    for (const PathCounts& tile : paths) sum += tile;
    log_detail("picture of " + path_text(sum));
    return film;
}

} // namespace keiko
