#pragma once

#include "keiko/base/memory.h"
#include "keiko/render/reflection/sample_batch.h"
#include "keiko/scene/camera.h"

#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// A part of the picture that one camera ray stands for: as a parallelogram around its centre, px.
struct PixelArea {
    Vec2 centre{0};
    Vec2 right{0}, down{0}; ///< edges
    double area = 0;        ///< of the part itself, px2
};

/// A convex polygon, its corners in order; room for what two cuts make of six of them.
using Polygon = InplaceVector<Vec2, 24>;

/// `size`: width and height.
PixelArea rectangle_part(const Vec2& corner, const Vec2& size);
/// The parallelogram with the centre and the second moments of a convex polygon that has an area;
/// corners in order, of either sense.
PixelArea polygon_part(std::span<const Vec2> corners);

/// Strip of a convex polygon of six corners at the most between two lines across a unit direction,
/// `begin` and `end` along it, px.
Polygon strip_of(std::span<const Vec2> corners, const Vec2& across, double begin, double end);

/// The mean over a convex polygon of what is linear in the triangles at its first corner; `values`
/// at the corners.
double polygon_mean(std::span<const Vec2> corners, std::span<const double> values);

/// The ray through the centre, with the part as its footprint.
Ray ray_of(const PreparedCamera& camera, const PixelArea& part);

/// A part of a pixel that shows one smooth thing, and what is seen there.
struct Subpixel {
    std::size_t pixel = 0;
    double share = 0; ///< of the pixel
    PixelSample sample{};
};

/// Pixels that hold outlines, in parts.
struct RefinedPixels {
    std::vector<Subpixel> parts;      ///< by rising pixel; the shares of each are 1 together
    std::vector<ShadingPoint> points; ///< of the parts, whose numbers are their samples
    std::vector<SampleBatch> views;   ///< what the samples point into
    HitStatistics paths;
};

/// Collects parts of pixels out of views that hold more than those.
class Subpixels {
public:
    /// Begins with a view; keep() takes its samples next.
    void open(SampleBatch view);
    const PixelSample& seen(std::size_t sample) const {
        return result_.views.back().samples[sample];
    }
    /// Takes a sample of the view for a part of a pixel.
    void keep(std::size_t sample, std::size_t pixel, double share);
    /// Ends with the view: the shading points of the samples that were taken go with them.
    void close();
    /// All parts; `probes`: hits of the other rays that were traced.
    RefinedPixels finish(const HitStatistics& probes);

private:
    RefinedPixels result_;
    std::vector<std::optional<std::size_t>> kept_; ///< parts of the samples of the view
};

} // namespace keiko
