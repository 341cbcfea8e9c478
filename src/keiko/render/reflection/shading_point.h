#pragma once

#include "keiko/geometry/visibility/ray.h"
#include "keiko/math/rgb.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// A visible place of a surface in a picture.
struct SurfacePlace {
    Vec3 position{0}, normal{0}; ///< world, mm; unit, of either sense
    std::uint32_t paint = 0;     ///< faces of one paint share this number
};

/// True if neighbours in a picture show one smooth surface. They have the same paint and normals
/// within 10 degrees, and are not both far from the other's tangent plane, as one surface in front
/// of another is.
bool is_same_surface(const SurfacePlace& a, const SurfacePlace& b);

/// Point at which a camera ray, or a mirror reflection of it, hits a surface whose base and lobes
/// are lit by the lamps directly.
struct ShadingPoint {
    std::size_t sample = 0; ///< of the camera rays, in their order
    int depth = 0;          ///< mirror reflections before
    SurfacePlace place{};   ///< its normal on the side of the viewer
    Root root{};            ///< of the hit, for rays from the point to leave out
    Vec3 eye{0};            ///< unit, towards the viewer
    Rgb weight{};           ///< weight of its luminance in the sample
};

/// Light of the lamps at a shading point: smooth along a surface except for shadows.
struct DirectLight {
    Rgb illuminance;     ///< lx, of what enters the base
    Rgb lobes;           ///< cd/m2, from lobes to the viewer
    double incident = 0; ///< lx on the first visible surface, if an AOV needs it

    /// Sum of both lights.
    DirectLight operator+(const DirectLight& o) const {
        return {illuminance + o.illuminance, lobes + o.lobes, incident + o.incident};
    }
    /// Adds another light.
    DirectLight& operator+=(const DirectLight& o) { return *this = *this + o; }
    /// Difference of both lights, which may be negative.
    DirectLight operator-(const DirectLight& o) const {
        return {illuminance - o.illuminance, lobes - o.lobes, incident - o.incident};
    }
    /// Light times a number.
    DirectLight operator*(double s) const { return {illuminance * s, lobes * s, incident * s}; }
};

/// Pairs of neighbours in a grid of places that show one smooth surface.
class SurfaceContinuity {
public:
    SurfaceContinuity() = default;
    /// Grid of `places` row by row, null if nothing is shown.
    SurfaceContinuity(int width, std::span<const SurfacePlace* const> places);

    /// True if the place of that number and its right neighbour show one smooth surface.
    bool right(std::size_t place) const { return joins_[place].right; }
    /// True if the place of that number and its lower neighbour show one smooth surface.
    bool down(std::size_t place) const { return joins_[place].down; }

private:
    struct Joins {
        bool right = false, down = false;
    };

    std::vector<Joins> joins_;
};

} // namespace keiko
