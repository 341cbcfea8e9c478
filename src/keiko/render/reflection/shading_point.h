#pragma once

#include "keiko/geometry/bezier/ray.h"
#include "keiko/math/rgb.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// A place of a surface as a picture shows it.
struct SurfacePlace {
    Vec3 position{0}, normal{0}; ///< world, mm; unit, of either sense
    std::uint32_t paint = 0;     ///< faces of one paint share this number
};

/// Whether neighbours in a picture show one smooth surface: of the same paint, turned by less than
/// 10 degrees, and not both far off the other's tangent plane, as one surface before another is.
bool is_same_surface(const SurfacePlace& a, const SurfacePlace& b);

/// Point where a camera ray, or a mirror reflection of it, meets a surface whose base and lobes are
/// lit by the lamps directly.
struct ShadingPoint {
    std::size_t sample = 0; ///< of the camera rays, in their order
    int depth = 0;          ///< mirror reflections before
    SurfacePlace place{};   ///< its normal on the side of the eye
    Root root{};
    Vec3 eye{0};  ///< unit, towards where it is seen from
    Rgb weight{}; ///< what its luminance counts in the sample
};

/// Light of the lamps at a shading point: smooth along a surface except for shadows.
struct DirectLight {
    Rgb illuminance; ///< lx, of what enters the base
    Rgb lobes;       ///< cd/m2, from lobes to the eye
    double incident =
        0; ///< lx on the surface, of what the eye sees first, where an AOV asks for it

    DirectLight operator+(const DirectLight& o) const {
        return {illuminance + o.illuminance, lobes + o.lobes, incident + o.incident};
    }
    DirectLight& operator+=(const DirectLight& o) { return *this = *this + o; }
    DirectLight operator-(const DirectLight& o) const {
        return {illuminance - o.illuminance, lobes - o.lobes, incident - o.incident};
    }
    DirectLight operator*(double s) const { return {illuminance * s, lobes * s, incident * s}; }
};

/// Which neighbours in a grid of places show one smooth surface.
class SurfaceContinuity {
public:
    SurfaceContinuity() = default;
    /// `places`: row by row, null where nothing is shown.
    SurfaceContinuity(int width, std::span<const SurfacePlace* const> places);

    /// Whether the place of that number and its right or lower neighbour do.
    bool right(std::size_t place) const { return joins_[place].right; }
    bool down(std::size_t place) const { return joins_[place].down; }

private:
    struct Joins {
        bool right = false, down = false;
    };

    std::vector<Joins> joins_;
};

} // namespace keiko
