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
    int x = 0, y = 0;
    std::size_t number = 0;
};

/// Places of a grid along a Hilbert curve, or several of squares side by side where it is much
/// longer than wide. Rays through places that follow each other stay together, which those of a row
/// do not. Valid until the thread requests a grid of another size.
const std::vector<GridPlace>& hilbert_order(int width, int height);

/// Sample of one camera ray.
struct PixelSample {
    Rgb luminance;            ///< cd/m2
    const Hit* hit = nullptr; ///< the first surface, of SampleBatch::hits; null: none, or not kept
    double cosine = 0;        ///< of the angle at which it is seen, 0 to 1
    double illuminance = 0;   ///< lx of direct light on it, where an AOV asks for it
    // The next three where outlines or AOVs ask for them, else as of no reflected ray.
    /// Where the first reflected ray meets the nearest C-plane, mm; nothing where the body is in
    /// the way.
    std::optional<Vec2> c_plane;
    double across_lamps = 0; ///< the same across that plane's lamps, in their pitches
    /// The face that the first reflected ray meets, or nothing where it leaves the body.
    std::optional<std::uint32_t> mirrored_face;
    /// The image of the pixel that the first reflected ray stands for is not smooth.
    bool discontinuous = false;
    bool covered = false;    ///< there is a first surface
    bool lit = false;        ///< it has shading points, whose light comes later
    std::uint32_t paint = 0; ///< faces of one paint share this number
    HitStatistics paths;     ///< of its hits, the reflected rays' too
};

/// Surface place of a sample with a hit.
inline SurfacePlace place_of(const PixelSample& sample) {
    return {sample.hit->position, sample.hit->normal, sample.paint};
}

/// Camera rays through places of a grid, which are numbered row by row.
struct TileRays {
    int width = 0, height = 0;
    /// Places with rays, neighbours together. Rays through other places miss the model, or were
    /// followed before: the first two rows of a grid that continues another are that one's last
    /// two.
    std::vector<GridPlace> places;
    /// The rays through some of them, in order.
    std::function<Rays(std::span<const GridPlace> places)> rays;
    bool continues_above = false, continues_below = false;

    /// Whether it is at the border of this grid and of those it continues.
    bool at_border(const GridPlace& place) const {
        return place.x == 0 || place.x + 1 == width || (place.y == 0 && !continues_above) ||
               (place.y + 1 == height && !continues_below);
    }
};

/// Samples of camera rays without the light of lamps on bases and lobes, and where that falls.
struct SampleBatch {
    SampleBatch() = default;
    SampleBatch(SampleBatch&&) = default; // samples point into `hits`, which stay where they are
    SampleBatch& operator=(SampleBatch&&) = default;

    std::vector<PixelSample> samples; ///< one a ray or place, in order
    std::vector<ShadingPoint> points; ///< that take such light; by depth, then by sample
    std::vector<Hits> hits;           ///< first surfaces
};

/// The inner part of the view of a grid, `width` in a row, one place off on all sides.
SampleBatch without_border(SampleBatch view, int width);

} // namespace keiko
