#pragma once

#include "keiko/base/memory.h"
#include "keiko/render/reflection/sample_batch.h"
#include "keiko/scene/camera.h"

#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// A part of the picture that one camera ray represents, as a parallelogram around its centre, px.
struct PixelArea {
    Vec2 centre{0};         ///< where the ray goes through
    Vec2 right{0}, down{0}; ///< edges
    double area = 0;        ///< of the part itself, px2
};

/// A convex polygon, its corners in order, with capacity for a six-sided one after two cuts.
using Polygon = InplaceVector<Vec2, 24>;

/// Area of a rectangle with the upper left corner at `corner`; `size`: width and height, px.
PixelArea rectangle_part(const Vec2& corner, const Vec2& size);
/// The parallelogram with the centre and the second moments of a convex polygon that has an area;
/// corners in order, of either sense.
PixelArea polygon_part(std::span<const Vec2> corners);

/// Strip of a convex polygon of at most six corners between two lines across a unit direction,
/// `begin` and `end` along it, px.
Polygon strip_of(std::span<const Vec2> corners, const Vec2& across, double begin, double end);

/// The mean over a convex polygon of a function that is linear in the triangles at its first
/// corner; `values` at the corners.
double polygon_mean(std::span<const Vec2> corners, std::span<const double> values);

/// The ray through the centre, with the part as its footprint.
Ray ray_of(const PreparedCamera& camera, const PixelArea& part);

/// A part of a pixel that shows one smooth thing, and its sample.
struct Subpixel {
    std::size_t pixel = 0; ///< number of its pixel
    double share = 0;      ///< of the pixel
    PixelSample sample{};  ///< of the ray through the part
};

/// Pixels that contain edges, in parts.
struct RefinedPixels {
    std::vector<Subpixel> parts;      ///< by rising pixel; the shares of each are 1 together
    std::vector<ShadingPoint> points; ///< of the parts, whose numbers are their samples
    std::vector<SampleBatch> views;   ///< views that the samples point into
    HitStatistics paths;              ///< of all rays traced for them, also of those left out
};

/// Collects parts of pixels from larger views.
class Subpixels {
public:
    /// Begins with a view; keep() takes its samples next.
    void open(SampleBatch view);
    /// Sample of the view that was opened last.
    const PixelSample& seen(std::size_t sample) const {
        return result_.views.back().samples[sample];
    }
    /// Adds a sample of the view as a part of a pixel.
    void keep(std::size_t sample, std::size_t pixel, double share);
    /// Ends the view, with the shading points of the added samples.
    void close();
    /// All parts; `probes`: hits of the other rays that were traced.
    RefinedPixels finish(const HitStatistics& probes);

private:
    RefinedPixels result_;
    std::vector<std::optional<std::size_t>> kept_; ///< parts of the samples of the view
};

} // namespace keiko
