#include "keiko/base/log.h"
#include "keiko/base/parallel.h"
#include "keiko/render/hilbert_order.h"
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

/// Pixels a side of a tile. What is found around it is found for its neighbours again, so that
/// larger ones cost less where nothing but that is to be done.
constexpr int tile_size = 32, mirror_tile_size = 64;

/// A square piece of the picture, rendered by one thread.
struct Tile {
    int x0, y0, x1, y1;
};

std::vector<Tile> tiles_of(const Camera& camera, int size) {
    std::vector<Tile> tiles;
    for (int y = 0; y < camera.height; y += size)
        for (int x = 0; x < camera.width; x += size)
            tiles.push_back(
                {x, y, std::min(x + size, camera.width), std::min(y + size, camera.height)});
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
    const auto& order = hilbert_order(grid.width, grid.height);
    grid.places.reserve(order.size());
    for (const GridPlace& place : order)
        if (eye.may_meet(bordered.x0 + place.x, bordered.y0 + place.y))
            grid.places.push_back(place);
    grid.rays = [&eye, bordered](std::span<const GridPlace> places) {
        std::vector<Vec2> points;
        points.reserve(places.size());
        for (const GridPlace& place : places)
            points.emplace_back(bordered.x0 + place.x + 0.5, bordered.y0 + place.y + 0.5);
        return eye.camera.rays(points);
    };
    return grid;
}

/// One ray a pixel, those of pixels `in_parts` without the light of spots. The view is one pixel
/// wider.
PathCounts render_centres(const Integrator& integrator, const Tile& tile, double light_error,
                          const std::vector<bool>& in_parts, EyeView view, Film& film) {
    const int width = tile.x1 - tile.x0;
    int border = 1;
    if (!view.spots.empty()) {
        view = without_border(std::move(view), width + 2);
        border = 0;
        add_interpolated_light(integrator, width, in_parts, light_error, view);
    }
    PathCounts paths;
    for_each_pixel(tile, [&](int x, int y) {
        const int row = y - tile.y0 + border, column = x - tile.x0 + border;
        const EyeSample& sample =
            view.samples[static_cast<std::size_t>(row * (width + 2 * border) + column)];
        paths += sample.paths;
        write_pixel(film, x, y, sample);
    });
    return paths;
}

/// The pixels of a tile that may hold outlines, with what their centres show unless they are torn.
std::vector<OutlineCell> outlined_cells(const Tile& tile, std::span<const Outline> outlines,
                                        std::span<const EyeSample> samples) {
    const auto width = static_cast<std::size_t>(tile.x1 - tile.x0);
    std::vector<OutlineCell> cells;
    std::size_t pixel = 0;
    for_each_pixel(tile, [&](int x, int y) {
        const Outline outline = outlines[pixel];
        const std::size_t place =
            (pixel / width + 1) * (width + 2) + pixel % width + 1; // the view is one pixel wider
        if (outline != Outline::none)
            cells.push_back(
                {pixel, Vec2(x, y), Vec2(1), outline == Outline::torn ? nullptr : &samples[place]});
        ++pixel;
    });
    return cells;
}

/// Replaces the luminance of pixels by the mean over their parts.
void write_parts(const RefinedPixels& refined, const Tile& tile, Film& film) {
    const auto width = static_cast<std::size_t>(tile.x1 - tile.x0);
    std::vector<EyeSample> samples;
    std::vector<double> shares;
    const std::vector<PixelPart>& parts = refined.parts;
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
                              const Tile& tile, int edge_samples, const EyeView& view) {
    if (edge_samples == 1) return {};
    const std::vector<Outline> outlines = outlines_of(view.samples, tile.x1 - tile.x0 + 2);
    return refined_pixels(integrator, eye.camera, outlined_cells(tile, outlines, view.samples),
                          1.0 / edge_samples);
}

/// Neighbours beyond the tile tell where outlines are and how the images of pixels are bent.
PathCounts render_tile(const Integrator& integrator, const PictureRays& eye, const Tile& tile,
                       const PictureOptions& options, Film& film) {
    const EyeGrid grid = grid_of(eye, tile);
    if (grid.places.empty()) {
        for_each_pixel(tile, [&, unseen = integrator.unseen()](int x, int y) {
            write_pixel(film, x, y, unseen);
        });
        return {};
    }
    EyeView view = integrator.view(grid);
    RefinedPixels refined = refine_outlines(integrator, eye, tile, options.edge_samples, view);
    add_shared_light(integrator, tile.x1 - tile.x0, options.light_error, refined);
    const int width = tile.x1 - tile.x0;
    std::vector<bool> in_parts(static_cast<std::size_t>(width * (tile.y1 - tile.y0)));
    for (const PixelPart& part : refined.parts) in_parts[part.pixel] = true;
    PathCounts paths =
        render_centres(integrator, tile, options.light_error, in_parts, std::move(view), film);
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
    const PictureRays eye = rays_of(scene, camera);
    const std::vector<Tile> tiles =
        tiles_of(camera, integrator.only_mirrors() ? mirror_tile_size : tile_size);
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
