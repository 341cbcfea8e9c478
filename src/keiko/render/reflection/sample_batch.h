#pragma once

#include "keiko/intersect/hit/hit.h"
#include "keiko/math/rgb.h"
#include "keiko/render/reflection/shading_point.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// A place of a grid, numbered row by row.
struct GridPlace {
    int x = 0, y = 0;       ///< column and row
    std::size_t number = 0; ///< y times the grid's width, plus x
};

/// Places of a grid along a Hilbert curve, or along several in squares side by side if the grid is
/// much longer than wide. Rays through consecutive places stay close together, unlike those of a
/// row. Valid until the thread requests a grid of another size.
const std::vector<GridPlace>& hilbert_order(int width, int height);

/// Sample of one camera ray.
struct PixelSample {
    Rgb luminance;            ///< cd/m2
    const Hit* hit = nullptr; ///< the first surface, of SampleBatch::hits; null: none, or not kept
    /// Normal of the first surface without the bumps of maps; empty if the scene has no maps.
    std::optional<Vec3> unbent;
    double cosine = 0;      ///< of the angle at which it is viewed, 0 to 1
    double illuminance = 0; ///< lx of direct light on it, if an AOV needs it
    // The next four if edges or AOVs need them, else as without a reflected ray.
    /// Intersection of the first reflected ray with the nearest C-plane, mm; nullopt if the body is
    /// in the way.
    std::optional<Vec2> c_plane;
    double across_lamps = 0; ///< position across that plane's lamps, in their pitches
    /// The face that the first reflected ray hits; nullopt if it leaves the body.
    std::optional<std::uint32_t> mirrored_face;
    /// The last surface that is seen through the first one and others, all glass; nullopt if there
    /// is none.
    std::optional<SurfacePlace> behind;
    /// True if the image of the pixel in the first reflected ray is not smooth.
    bool discontinuous = false;
    bool covered = false;    ///< true if there is a first surface
    bool lit = false;        ///< true if it has shading points, whose light is added later
    std::uint32_t paint = 0; ///< faces of one paint share this number
    HitStatistics paths;     ///< of its hits, the reflected rays' included
};

/// Surface place of a sample with a hit. Bumps are no edges, so it has the normal without them.
inline SurfacePlace place_of(const PixelSample& sample) {
    return {sample.hit->position, sample.unbent.value_or(sample.hit->normal), sample.paint};
}

/// Camera rays through places of a grid, which are numbered row by row.
struct TileRays {
    int width = 0, height = 0; ///< places a row, and rows
    /// Places with rays, neighbours together. Rays through other places miss the model.
    std::vector<GridPlace> places;
    /// The rays through some of them, in order.
    std::function<Rays(std::span<const GridPlace> places)> rays;
};

/// Samples of camera rays without the light of lamps on bases and lobes, and the points where that
/// falls.
struct SampleBatch {
    SampleBatch() = default;
    SampleBatch(SampleBatch&&) = default; // samples point into `hits`, which keep their addresses
    SampleBatch& operator=(SampleBatch&&) = default;

    std::vector<PixelSample> samples; ///< one a ray or place, in order
    std::vector<ShadingPoint>
        points;             ///< that receive such light; those of a branch together, by sample
    std::vector<Hits> hits; ///< first surfaces
};

/// The inner part of the view of a grid, `width` in a row, without one place on all sides.
SampleBatch without_border(SampleBatch view, int width);

} // namespace keiko
