#pragma once

#include "keiko/geometry/rays/ray.h"
#include "keiko/math/rgb.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace keiko {

struct MappedPaint;

/// A visible place of a surface in a picture.
struct SurfacePlace {
    Vec3 position{0}, normal{0}; ///< world, mm; unit, of either sense
    std::uint32_t paint = 0;     ///< faces of one paint share this number
};

/// Square of the tangent of the angle between the normals of one smooth surface, 10 degrees.
constexpr double widest_bend = 0.17632698070846498 * 0.17632698070846498;

/// True if neighbours in a picture show one smooth surface. They have the same paint and normals
/// within 10 degrees, and are not both far from the other's tangent plane, as one surface in front
/// of another is.
bool is_same_surface(const SurfacePlace& a, const SurfacePlace& b);

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

/// Point at which a camera ray, or a mirror reflection of it, hits a surface whose base and lobes
/// are lit by the lamps directly.
struct ShadingPoint {
    std::size_t sample = 0; ///< of the camera rays, in their order
    /// Way to it: 0 from the eye; from the place b by mirror reflection 2 b + 1, through it 2 b
    /// + 2.
    std::uint64_t branch = 0;
    SurfacePlace place{}; ///< its normal on the side of the viewer
    Root root{};          ///< of the hit, for rays from the point to leave out
    Vec3 eye{0};          ///< unit, towards the viewer
    Rgb weight{};         ///< weight of its luminance in the sample
    Vec3 along{0};        ///< of the scratches of a brushed paint, of any length
    /// Light that is found already: of caustics, and what is fitted over a tile.
    DirectLight known{};
    Rgb ambient{}; ///< lx from other surfaces, or of the rig's ambient light
    /// Its own paint and whether its light may be interpolated; of places with maps alone.
    std::shared_ptr<const MappedPaint> mapped{};
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

inline bool is_same_surface(const SurfacePlace& a, const SurfacePlace& b) {
    if (a.paint != b.paint) return false;
    // Normals compared as lines: neighbouring faces may be oriented differently.
    const double along = a.normal.dot(b.normal);
    if (a.normal.cross(b.normal).length2() > widest_bend * (along * along)) return false;
    // A step away from the tangent planes of both: one surface in front of another.
    const Vec3 step = b.position - a.position;
    const double off = std::min(std::abs(step.dot(a.normal)), std::abs(step.dot(b.normal)));
    constexpr double farthest = 0.2 * 0.2; // of the step, squared
    return !(off * off > farthest * step.length2());
}

inline SurfaceContinuity::SurfaceContinuity(int width, std::span<const SurfacePlace* const> places)
    : joins_(places.size()) {
    const auto w = static_cast<std::size_t>(width);
    const auto joined = [&](std::size_t a, std::size_t b) {
        return places[b] && is_same_surface(*places[a], *places[b]);
    };
    for (std::size_t row = 0; row < places.size(); row += w)
        for (std::size_t i = row; i < row + w; ++i) {
            if (!places[i]) continue;
            joins_[i] = {i + 1 < row + w && joined(i, i + 1),
                         i + w < places.size() && joined(i, i + w)};
        }
}

} // namespace keiko
