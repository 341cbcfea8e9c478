#pragma once

#include "keiko/light/areas/contour_light.h"
#include "keiko/math/bounds.h"
#include "keiko/math/interval_set.h"
#include "keiko/math/vec.h"

#include <optional>
#include <vector>

namespace keiko {

/// Axes and extents in which a point views a luminous body.
struct ContourView {
    Vec3 point;               ///< viewpoint, outside of the body
    Vec3 ahead, along;        ///< unit, at right angles: towards the body, and along the lines
    Box3 reach;               ///< of what is ahead of the point, by along, across and ahead, mm
    double distance;          ///< mm, of a plane across `ahead` behind the body
    ParameterInterval extent; ///< of the body on that plane, along the lines
    ParameterInterval turn;   ///< wedge angles of the body, radians, within a half turn

    /// Views from a point that together hold what is above its horizon of the body; none if that is
    /// nothing. Of a body afar it is one, ahead the middle of its box, of a near one those through
    /// the faces of half a cube, ahead first the normal.
    static std::vector<ContourView> all(const LuminousBody& body, const Vec3& point,
                                        const Vec3& normal);
    /// The view ahead up to a slope along the lines, and across them from one slope to another;
    /// nullopt if nothing of the body's box is there.
    static std::optional<ContourView> within(const LuminousBody& body, const Vec3& point,
                                             const Vec3& ahead, const Vec3& along,
                                             const ParameterInterval& across, double slope);
    /// The one of all(), or of several the whole half-space without a thousandth of it next to the
    /// horizon; nullopt if nothing of the body is above the horizon.
    static std::optional<ContourView> one(const LuminousBody& body, const Vec3& point,
                                          const Vec3& normal);
    /// True if a box appears within 75 degrees of its middle.
    static bool is_far(const Box3& box, const Vec3& point);
    /// Unit vector across the lines.
    Vec3 across() const { return ahead.cross(along); }
    /// Place on the plane at a wedge angle.
    Vec3 on_plane(double u, double wedge_angle) const;
};

} // namespace keiko
