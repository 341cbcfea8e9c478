#include "keiko/base/log.h"
#include "keiko/base/parallel.h"
#include "keiko/render/interpolated_light.h"
#include "keiko/render/outlines.h"
#include "keiko/render/picture_cover.h"
#include "keiko/render/pixel_writer.h"
#include "keiko/render/shared_light.h"
#include "keiko/spec/prepared_camera.h"

#include <algorithm>
#include <optional>
#include <utility>

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

/// The eye rays of a picture.
struct PictureRays {
    PreparedCamera camera;
    std::optional<PictureCover> cover; ///< others see nothing but the background

    bool may_meet(int x, int y) const { return !cover || cover->may_show(x, y); }
};

/// Where there is a medium, rays that meet nothing see it too.
PictureRays rays_of(const PictureScene& scene, const Camera& camera) {
    PictureRays rays{PreparedCamera(camera), std::nullopt};
    if (!scene.rig.medium) rays.cover.emplace(camera, scene.tracer.boxes());
    return rays;
}

/// A tile and the pixels around it.
EyeGrid grid_of(const PictureRays& eye, const Tile& tile) {
    const Tile bordered{tile.x0 - 1, tile.y0 - 1, tile.x1 + 1, tile.y1 + 1};
    EyeGrid grid{bordered.x1 - bordered.x0, bordered.y1 - bordered.y0, {}, {}};
    const auto size = static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height);
    grid.rays.reserve(size), grid.places.reserve(size);
    std::size_t place = 0;
    for_each_pixel(bordered, [&](int x, int y) {
        if (eye.may_meet(x, y)) {
            grid.rays.push_back(eye.camera.ray(x + 0.5, y + 0.5));
            grid.places.push_back(place);
        }
        ++place;
    });
    return grid;
}

/// The centres of a pixel's n x n cells as eye rays, each with the footprint of its cell.
void append_cell_rays(const PreparedCamera& camera, int x, int y, int n, std::vector<Ray>& rays) {
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
PathCounts refine_outlines(const Integrator& integrator, const PreparedCamera& camera,
                           const Tile& tile, int n, const std::vector<bool>& outlined, Film& film) {
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
PathCounts render_tile(const Integrator& integrator, const PictureRays& eye, const Tile& tile,
                       const PictureOptions& options, Film& film) {
    const int width = tile.x1 - tile.x0 + 2;
    EyeView view = integrator.view(grid_of(eye, tile));
    const bool refines = options.edge_samples > 1;
    const std::vector<bool> outlined =
        refines ? outlined_pixels(view.samples, width) : std::vector<bool>(view.samples.size());
    PathCounts paths = render_centres(integrator, tile, options.light_error, outlined,
                                      without_border(std::move(view), width), film);
    if (refines)
        paths +=
            refine_outlines(integrator, eye.camera, tile, options.edge_samples, outlined, film);
    return paths;
}

} // namespace

Film render(const PictureScene& scene, const Camera& camera, const PictureOptions& options,
            const Job& job) {
    Film film = blank_film(camera.width, camera.height, options.aovs);
    const bool from_eye = camera.projection == Projection::perspective;
    const Integrator integrator(scene, options, from_eye ? std::optional(camera.eye) : std::nullopt,
                                job);
    const PictureRays eye = rays_of(scene, camera);
    const std::vector<Tile> tiles = tiles_of(camera);
    std::vector<PathCounts> paths(tiles.size());
    parallel_for(tiles.size(), job, "render", [&](std::size_t i) {
        paths[i] = render_tile(integrator, eye, tiles[i], options, film);
    });
    PathCounts sum;
    for (const PathCounts& tile : paths) sum += tile;
    log_detail("picture of " + path_text(sum));
    return film;
}

} // namespace keiko
