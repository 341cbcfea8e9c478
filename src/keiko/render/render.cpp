#include "keiko/base/log.h"
#include "keiko/base/parallel.h"
#include "keiko/render/antialias/edge_detection.h"
#include "keiko/render/antialias/edge_pixel_lighting.h"
#include "keiko/render/antialias/edge_refinement.h"
#include "keiko/render/lighting/fitted_light.h"
#include "keiko/render/lighting/light_interpolation.h"
#include "keiko/render/tiles.h"

#include <map>
#include <optional>
#include <utility>
#include <vector>

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

/// Places of one branch, each with the points that have its light, and their samples.
struct LitTogether {
    struct Taker {
        ShadingPoint* point;
        PixelSample* sample;
    };

    std::vector<LitPlace> places;
    std::vector<std::vector<Taker>> takers; ///< by place
};

/// The places to be lit in a tile, by branch.
using LitBranches = std::map<std::uint64_t, LitTogether>;

LitBranches lit_places(int width, const std::vector<bool>& in_parts, SampleBatch& view,
                       RefinedPixels& refined) {
    LitBranches all;
    for (ShadingPoint& point : view.points) {
        if (in_parts[point.sample]) continue;
        const auto number = static_cast<int>(point.sample);
        PixelSample& sample = view.samples[point.sample];
        LitTogether& lit = all[point.branch];
        lit.places.push_back({{number % width, number / width}, &point, sample.luminance});
        lit.takers.push_back({{&point, &sample}});
    }
    const auto taker = [&](const OutlineSpot& spot) {
        return &refined.points[static_cast<std::size_t>(spot.point - refined.points.data())];
    };
    for (const SharedPlace& shared : shared_places(width, refined)) {
        const ShadingPoint& point = *shared.lit.point;
        LitTogether& lit = all[point.branch];
        const auto sample = [&](const ShadingPoint& of) {
            return &refined.parts[of.sample].sample;
        };
        lit.places.push_back({shared.lit.pixel, &point, sample(point)->luminance});
        lit.takers.emplace_back();
        for (const OutlineSpot& spot : shared.points)
            lit.takers.back().push_back({taker(spot), sample(*spot.point)});
    }
    return all;
}

/// Adds the smooth lights to the known light of shading points; see fitted_light().
void find_smooth_light(const Integrator& integrator, double error, const LitBranches& all) {
    const std::vector<LightId>& lights = integrator.smooth_lights();
    for (const auto& [branch, lit] : all) {
        const std::vector<DirectLight> light = fitted_light(integrator, lights, lit.places, error);
        for (std::size_t i = 0; i < light.size(); ++i)
            for (const auto& [point, sample] : lit.takers[i]) point->known += light[i];
    }
}

/// Adds the known light of shading points to their samples.
void add_known_light(const Integrator& integrator, const LitBranches& all) {
    for (const auto& [branch, lit] : all)
        for (const auto& takers : lit.takers)
            for (const auto& [point, sample] : takers) integrator.add_light(*point, {}, *sample);
}

/// Adds the light of all shading points of a tile, `width` pixels in a row, to their samples: of
/// the pixels of one ray, `view`, and of the parts of the others. The samples in `view` of pixels
/// in parts are left as they are. The light may deviate by `error` of the visible luminance where
/// it is tested; see light_interpolation(), add_shared_light() and fitted_light().
void add_tile_light(const Integrator& integrator, int width, double error, SampleBatch& view,
                    RefinedPixels& refined) {
    std::vector<bool> in_parts(view.samples.size());
    for (const Subpixel& part : refined.parts) in_parts[part.pixel] = true;
    const bool all_smooth = integrator.interpolated_lights().empty();
    if (all_smooth || !integrator.smooth_lights().empty()) {
        const LitBranches lit = lit_places(width, in_parts, view, refined);
        find_smooth_light(integrator, error, lit);
        if (all_smooth) return add_known_light(integrator, lit);
    }
    add_shared_light(integrator, width, error, refined);
    add_interpolated_light(integrator, width, in_parts, error, view);
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
