#pragma once

#include "keiko/geometry/rays/ray.h"
#include "keiko/light/rig/prepared_rig.h"
#include "keiko/math/bounds.h"
#include "keiko/math/rgb.h"

#include <span>
#include <vector>

namespace keiko {

/// Rays of a point light or a sun by two coordinates: those of a plane at the distance 1 from the
/// light, or, in mm, of a plane across parallel light.
class LightChart {
public:
    /// Ray of the light, with differentials by the coordinates.
    Ray ray(const Vec2& at) const;
    /// Light in lm for an area of 1 of the coordinates; of a sun as at a place that it reaches.
    Rgb flux(const Vec2& at) const;
    /// Area, mm2, of an area of 1 of the coordinates across the middle of the chart at a place.
    double spread(const Vec3& place) const;
    /// Coordinates of all rays that can meet what the chart was made for.
    const Box2& range() const { return range_; }
    /// True if the light reaches a place, mm, as far as windows decide it.
    bool reaches(const Vec3& place) const;
    /// Place, mm, from which on light to a first surface at `place` passes the medium: the light,
    /// or where sunlight comes in by a window; `place` itself of a sun without windows, whose light
    /// at the scene is what arrives.
    Vec3 start_in_medium(const Vec3& place) const;

private:
    friend class ChartsOf;
    LightChart(const PreparedSource& source, const Vec3& origin, const Vec3& forward,
               bool parallel);

    Vec2 coordinates(const Vec3& place) const;
    void cover(std::span<const Box3> boxes);

    const PreparedSource* source_;
    Vec3 origin_;  ///< mm, the light, or a place before everything
    Vec3 forward_; ///< unit, and so are the next
    Vec3 right_{0}, up_{0};
    bool parallel_;
    Box2 range_;
};

/// True for sources whose caustics are found: points, spotlights, luminaires and suns.
bool casts_caustics(const PreparedSource& source);

/// Charts of all rays of a source from which surfaces in some boxes, mm, can be lit. Empty for
/// sources that are neither points nor parallel. Parallel rays begin outside of `scene`, a box
/// around everything. A reference to the source is kept.
std::vector<LightChart> charts_of(const PreparedSource& source, std::span<const Box3> boxes,
                                  const Box3& scene);

} // namespace keiko
