#pragma once

#include "keiko/light/tubes/c_plane.h"

namespace keiko {

/// A C-plane made ready for computing: unit axes, v orthogonal to u, and the comb of lamp axes.
/// Frame coordinates are (u, v, height over the plane) in mm from the corner. A plane without
/// extent has NaN axes, which no ray hits and no point sees.
struct CPlaneFrame {
    Vec3 origin, u, v, normal;
    double length = 0; ///< of the lamps, mm
    double first = 0;  ///< v of the first lamp's axis, mm
    double pitch = 0;  ///< mm
    double diameter = 0;
    int lamps = 0;
    bool luminous_caps = false;

    explicit CPlaneFrame(const CPlane& plane)
        : origin(plane.origin),
          length(plane.u.length()),
          diameter(plane.diameter),
          lamps(plane.lamps > 0 ? plane.lamps : 0),
          luminous_caps(plane.luminous_caps) {
        u = plane.u / length;
        const Vec3 across = plane.v - u * u.dot(plane.v);
        const double width = across.length();
        v = across / width;
        normal = u.cross(v);
        if (lamps == 0) return;
        pitch = plane.pitch > 0 ? plane.pitch : width / lamps;
        first = (width - (lamps - 1) * pitch) / 2;
    }

    double radius() const { return diameter / 2; }
    double axis(int lamp) const { return first + lamp * pitch; }
    double last() const { return axis(lamps - 1); }
    Vec3 vector(const Vec3& w) const { return {u.dot(w), v.dot(w), normal.dot(w)}; }
    Vec3 point(const Vec3& p) const { return vector(p - origin); }
    /// World position of the point (along, across) of the plane.
    Vec3 at(double along, double across) const { return origin + u * along + v * across; }
};

} // namespace keiko
