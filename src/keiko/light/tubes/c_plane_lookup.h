#pragma once

#include "keiko/light/tubes/plane_image.h"

#include <optional>

namespace keiko {

/// Intersection of a ray with the plane; nullopt for a ray that points away from the plane or is
/// within 1e-12 rad of parallel to it.
std::optional<CPlaneHit> c_plane_coordinates(const CPlaneFrame& frame, const Vec3& origin,
                                             const Vec3& direction);
std::optional<CPlaneHit> c_plane_coordinates(const CPlane& plane, const Vec3& origin,
                                             const Vec3& direction);

/// Share of a reflected ray, or of a pixel of them, that a row of lamps fills.
struct LampCoverage {
    double coverage = 0;  ///< share of the pixel that lamps fill, 0 to 1
    bool resolved = true; ///< false: over 4 pitches in a pixel; the coverage is the mean
};

/// Coverage of a ray or pixel by the lamps on the plane (docs/theory/luminance.md#in-mirrors); both
/// sides of it are visible. A point is intersected exactly, end caps included. A footprint is
/// integrated in closed form over strips of the tubes' apparent width up to the images of their
/// rims, or (exact) is the mean over 256 parallel rays. The light between the lamps and occluders
/// before them are the caller's task.
LampCoverage look_up(const CPlaneFrame& frame, const Vec3& origin, const Vec3& direction,
                     const Footprint& footprint = {}, MirrorModel look = MirrorModel::tube);
/// Coverage of a ray that is known to meet the plane at `hit`.
LampCoverage look_up(const CPlaneFrame& frame, const CPlaneHit& hit, const Vec3& origin,
                     const Vec3& direction, const Footprint& footprint, MirrorModel look);

/// Luminance in cd/m2 of a row of lamps along a ray, darkness between the lamps.
Rgb mirrored_luminance(const CPlane& plane, const Vec3& origin, const Vec3& direction,
                       const Footprint& footprint = {}, MirrorModel look = MirrorModel::tube);

/// The strip that holds the point (u, v), by rising v; nullopt between the strips. `width` in mm.
std::optional<int> strip_at(const CPlaneFrame& frame, double u, double v, double width);

} // namespace keiko
