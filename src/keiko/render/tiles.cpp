#include "keiko/render/tiles.h"

#include "keiko/light/rig/rig_areas.h"
#include "keiko/light/rig/rig_sky.h"
#include "keiko/maps/scene_maps.h"
#include "keiko/render/reflection/sample_batch.h"
#include "keiko/scene/camera.h"
#include "keiko/texels/scene_texels.h"
#include "keiko/volumes/scene_volumes.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace keiko {

namespace {

/// Number of boxes beyond which neighbours in their order are merged, so that no model is slow.
constexpr std::size_t most_boxes = 1 << 15;

std::vector<Box3> joined(std::span<const Box3> boxes) {
    const std::size_t run = boxes.size() / most_boxes + 1;
    std::vector<Box3> joined((boxes.size() + run - 1) / run);
    for (std::size_t i = 0; i < boxes.size(); ++i) joined[i / run].extend(boxes[i]);
    return joined;
}

/// mm: far more than rounding moves a ray, a surface or a projected corner.
double margin_of(const Camera& camera, std::span<const Box3> boxes) {
    Box3 all;
    for (const Box3& box : boxes) all.extend(box);
    if (all.empty()) return 0;
    return 1e-9 * (all.size() + all.center().length() + camera.eye.length());
}

/// The pixels around the corners of a box in the picture; nullopt if one of them is not before the
/// camera.
std::optional<Box2> shown(const PreparedCamera& camera, const Box3& box) {
    Box2 shown;
    for (const double x : {box.lower.x, box.upper.x})
        for (const double y : {box.lower.y, box.upper.y})
            for (const double z : {box.lower.z, box.upper.z}) {
                const auto at = camera.project({x, y, z});
                if (!at || !std::isfinite(at->x + at->y)) return {};
                shown.extend(*at);
            }
    return shown;
}

/// Number of rectangles that contain each cell of a grid: their corners are counted, then summed
/// up.
class RectangleCounts {
public:
    RectangleCounts(int columns, int rows)
        : columns_(static_cast<std::size_t>(columns)),
          rows_(static_cast<std::size_t>(rows)),
          counts_((columns_ + 1) * (rows_ + 1)) {}

    /// Adds a rectangle, its last column and row included.
    void add(std::size_t x0, std::size_t y0, std::size_t x1, std::size_t y1) {
        at(x0, y0) += 1, at(x1 + 1, y1 + 1) += 1;
        at(x1 + 1, y0) -= 1, at(x0, y1 + 1) -= 1;
    }
    std::vector<std::uint8_t> held() {
        std::vector<std::uint8_t> held(columns_ * rows_);
        for (std::size_t y = 0; y < rows_; ++y)
            for (std::size_t x = 0; x < columns_; ++x) {
                if (x > 0) at(x, y) += at(x - 1, y);
                if (y > 0) at(x, y) += at(x, y - 1);
                if (x > 0 && y > 0) at(x, y) -= at(x - 1, y - 1);
                held[y * columns_ + x] = at(x, y) > 0;
            }
        return held;
    }

private:
    int& at(std::size_t x, std::size_t y) { return counts_[y * (columns_ + 1) + x]; }

    std::size_t columns_, rows_;
    std::vector<int> counts_;
};

} // namespace

ScreenBounds::ScreenBounds(const Camera& camera, std::span<const Box3> boxes)
    : columns_(cell_at(camera.width) + 1), rows_(cell_at(camera.height) + 1) {
    RectangleCounts counts(columns_, rows_);
    const PreparedCamera prepared(camera);
    const double margin = margin_of(camera, boxes);
    const auto cell_of = [](double at, int cells) {
        return static_cast<std::size_t>(
            std::clamp(std::floor((at + cell) / cell), 0.0, cells - 1.0));
    };
    for (const Box3& box : joined(boxes)) {
        if (box.empty()) continue;
        constexpr double all = Box2::infinity;
        const Box2 pixels =
            shown(prepared, box.padded(margin)).value_or(Box2{Vec2(-all), Vec2(all)});
        if (pixels.upper.x < -cell || pixels.upper.y < -cell ||
            pixels.lower.x > camera.width + cell || pixels.lower.y > camera.height + cell)
            continue;
        counts.add(cell_of(pixels.lower.x, columns_), cell_of(pixels.lower.y, rows_),
                   cell_of(pixels.upper.x, columns_), cell_of(pixels.upper.y, rows_));
    }
    shown_ = counts.held();
}

std::vector<Tile> tiles_of(const Camera& camera, int width, int height) {
    std::vector<Tile> tiles;
    for (int y = 0; y < camera.height; y += height)
        for (int x = 0; x < camera.width; x += width)
            tiles.push_back(
                {x, y, std::min(x + width, camera.width), std::min(y + height, camera.height)});
    return tiles;
}

PictureRays::PictureRays(const PictureScene& scene, const Camera& seen_by) : camera(seen_by) {
    // Rays that miss the scene show a medium, the sky and the surroundings, too.
    const Environment* environment = scene.maps ? scene.maps->environment() : nullptr;
    if (scene.rig.medium || !RigSky(scene.rig).empty() ||
        (environment && environment->spec().visible))
        return;
    const std::span<const Box3> surfaces = scene.tracer.boxes();
    std::vector<Box3> boxes = RigAreas(scene.rig).boxes();
    boxes.insert(boxes.end(), surfaces.begin(), surfaces.end());
    if (scene.volumes) {
        const std::vector<Box3> volumes = scene.volumes->boxes();
        boxes.insert(boxes.end(), volumes.begin(), volumes.end());
    }
    if (scene.texels) {
        const std::vector<Box3> texels = scene.texels->boxes();
        boxes.insert(boxes.end(), texels.begin(), texels.end());
    }
    cover.emplace(seen_by, boxes);
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

HitStatistics write_samples(std::span<const PixelSample> samples, const Tile& tile, Film& film) {
    const auto width = static_cast<std::size_t>(tile.width());
    HitStatistics paths;
    for (const PixelSample& sample : samples) paths += sample.paths;
    for (int y = tile.y0; y < tile.y1; ++y, samples = samples.subspan(width))
        write_row(film, tile.x0, y, samples.first(width));
    return paths;
}

void write_unseen(const Integrator& integrator, const Tile& tile, Film& film) {
    const std::vector<PixelSample> row(static_cast<std::size_t>(tile.width()), integrator.unseen());
    for (int y = tile.y0; y < tile.y1; ++y) write_row(film, tile.x0, y, row);
}

} // namespace keiko
