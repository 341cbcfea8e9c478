#include "keiko/render/deep_buffer.h"

#include "keiko/base/parallel.h"
#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/intersect/hit/reflect_ray.h"
#include "keiko/math/unit_vectors.h"
#include "keiko/render/tiles.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>

namespace keiko {

static_assert(sizeof(DeepSample) == 32 && sizeof(DeepBounce) == 36);

std::array<RowSet, 4> interlaced_rows() {
    return {RowSet{0, 8}, RowSet{4, 8}, RowSet{2, 4}, RowSet{1, 2}};
}

Vec3 DeepSample::normal() const {
    return from_octahedral({static_cast<double>(normal_x), static_cast<double>(normal_y)});
}

std::array<Vec3, 2> DeepSample::axes() const {
    const float sum = std::abs(normal_x) + std::abs(normal_y);
    const AxesAcross across(normal(), sum > 1 ? -1 : 1);
    return {across.x, across.y};
}

namespace {

/// Camera rays that are traced together with their reflected rays, as in pictures: few enough for
/// their data to stay in the processor's cache.
constexpr std::size_t rays_at_once = 256;
/// Size of a tile in pixels and in rows of the set; one thread traces it.
constexpr int tile_width = 64, tile_rows = 16;

/// Sets the second fundamental form along the axes of the stored normal.
void set_shape(DeepSample& sample, const Hit& hit, const Vec3& normal) {
    const SurfaceDerivatives surface = derivatives_of(hit);
    if (!has_reliable_curvatures(surface, normal)) {
        sample.shape_xx = sample.shape_xy = sample.shape_yy =
            std::numeric_limits<float>::quiet_NaN();
        return;
    }
    const SecondForm form = second_form(surface, normal, sample.axes()[0]);
    sample.shape_xx = static_cast<float>(form.xx);
    sample.shape_xy = static_cast<float>(form.xy);
    sample.shape_yy = static_cast<float>(form.yy);
}

DeepSample sample_of(const Ray& ray, const Hit& hit) {
    const Vec3 normal = hit.normal.dot(ray.direction) > 0 ? -hit.normal : hit.normal;
    const Vec2 place = octahedral(normal);
    DeepSample sample;
    sample.t = static_cast<float>(hit.t);
    sample.normal_x = static_cast<float>(place.x), sample.normal_y = static_cast<float>(place.y);
    sample.face = static_cast<float>(hit.face + 1);
    set_shape(sample, hit, normal);
    return sample;
}

/// A tile of the rows of a buffer, with what its pixels mirror.
class DeepTile {
public:
    /// `tile`: in columns and in numbers of rows of the set.
    DeepTile(const Tracer& tracer, const DeepOptions& options, const Tile& tile, DeepBuffer& buffer)
        : tracer_(tracer), options_(options), tile_(tile), buffer_(buffer) {}

    /// Writes the samples of its pixels. Returns the bounces, in the order of the reflections.
    std::vector<DeepBounce> trace(const PreparedCamera& camera, const ScreenBounds& cover) {
        std::vector<Vec2> pixels;
        for (const GridPlace& place : hilbert_order(tile_.width(), tile_.height())) {
            const int x = tile_.x0 + place.x, y = row(tile_.y0 + place.y);
            if (cover.may_show(x, y)) pixels.emplace_back(x, y);
        }
        for (std::size_t first = 0; first < pixels.size(); first += rays_at_once)
            trace(camera,
                  std::span(pixels).subspan(first, std::min(rays_at_once, pixels.size() - first)));
        return std::move(bounces_);
    }

private:
    /// Rays of one depth, and the pixel of each.
    struct Paths {
        Rays rays;
        std::vector<std::uint32_t> pixels;
    };

    int row(int number) const { return options_.rows.first + number * options_.rows.step; }

    void trace(const PreparedCamera& camera, std::span<const Vec2> pixels) {
        Paths paths = camera_paths(camera, pixels);
        std::vector<DeepBounce> met; // what reflects the rays in hand, one a ray
        for (int depth = 0; !paths.rays.empty(); ++depth) {
            const bool last = depth == options_.reflections;
            const FirstHits hits =
                tracer_.first_hits(paths.rays, last ? HitDetail::face : HitDetail::all);
            for (std::size_t i = 0; i < met.size(); ++i)
                if (hits[i]) met[i].sample.way = static_cast<float>(hits[i]->t);
            keep(met, depth - 1);
            if (last) return;
            met.clear();
            paths = reflected(paths, hits, met);
        }
    }

    Paths camera_paths(const PreparedCamera& camera, std::span<const Vec2> pixels) const {
        Paths paths;
        std::vector<Vec2> centres;
        centres.reserve(pixels.size()), paths.pixels.reserve(pixels.size());
        for (const Vec2& pixel : pixels) {
            centres.push_back(pixel + Vec2(0.5));
            paths.pixels.push_back(static_cast<std::uint32_t>(pixel.y) *
                                       static_cast<std::uint32_t>(buffer_.width) +
                                   static_cast<std::uint32_t>(pixel.x));
        }
        paths.rays = camera.rays(centres);
        // The viewer derives the differentials of reflected rays from the shape.
        for (Ray& ray : paths.rays) ray.differentials.reset();
        return paths;
    }

    /// The rays that the hits reflect; `met` gets the sample of each hit.
    static Paths reflected(const Paths& paths, const FirstHits& hits,
                           std::vector<DeepBounce>& met) {
        Paths mirrored;
        mirrored.rays.reserve(hits.hits.size()), mirrored.pixels.reserve(hits.hits.size());
        for (std::size_t i = 0; i < paths.rays.size(); ++i) {
            if (!hits[i]) continue;
            met.push_back({paths.pixels[i], sample_of(paths.rays[i], *hits[i])});
            mirrored.rays.push_back(reflect_ray(paths.rays[i], *hits[i]));
            mirrored.pixels.push_back(paths.pixels[i]);
        }
        return mirrored;
    }

    /// Keeps finished samples, after `depth` reflections.
    void keep(std::span<const DeepBounce> met, int depth) {
        if (depth > 0) bounces_.insert(bounces_.end(), met.begin(), met.end());
        if (depth != 0) return;
        const auto width = static_cast<std::uint32_t>(buffer_.width);
        for (const auto& [pixel, sample] : met) {
            const int number =
                (static_cast<int>(pixel / width) - options_.rows.first) / options_.rows.step;
            buffer_.samples[static_cast<std::size_t>(number) * width + pixel % width] = sample;
        }
    }

    const Tracer& tracer_;
    const DeepOptions& options_;
    const Tile& tile_;
    DeepBuffer& buffer_;
    std::vector<DeepBounce> bounces_;
};

/// Tiles of the first rows of a picture.
std::vector<Tile> tiles_of_rows(const Camera& camera, int rows) {
    Camera part = camera;
    part.height = rows;
    return tiles_of(part, tile_width, tile_rows);
}

} // namespace

DeepBuffer deep_buffer(const Tracer& tracer, const Camera& camera, const DeepOptions& options,
                       const Job& job) {
    assert(options.rows.step >= 1 && options.rows.first >= 0 && options.reflections >= 1);
    const int rows = options.rows.count(camera.height);
    DeepBuffer buffer{camera.width, camera.height, options.rows, {}, {}};
    buffer.samples.resize(static_cast<std::size_t>(rows) * static_cast<std::size_t>(camera.width));
    const PreparedCamera prepared(camera);
    const ScreenBounds cover(camera, tracer.boxes());
    const std::vector<Tile> tiles = tiles_of_rows(camera, rows);
    std::vector<std::vector<DeepBounce>> bounces(tiles.size());
    parallel_for(tiles.size(), job, "deep buffer", [&](std::size_t i) {
        bounces[i] = DeepTile(tracer, options, tiles[i], buffer).trace(prepared, cover);
    });
    for (const auto& of_tile : bounces)
        buffer.bounces.insert(buffer.bounces.end(), of_tile.begin(), of_tile.end());
    std::stable_sort(buffer.bounces.begin(), buffer.bounces.end(),
                     [](const DeepBounce& a, const DeepBounce& b) { return a.pixel < b.pixel; });
    return buffer;
}

} // namespace keiko
