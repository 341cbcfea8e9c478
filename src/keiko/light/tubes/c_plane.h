#pragma once

#include "keiko/base/export.h"
#include "keiko/math/rgb.h"
#include "keiko/math/vec.h"

namespace KEIKO_API keiko {

/// Models of a cylindrical lamp, from the facing rectangle [NishitaTubes, eq. 1] to the exact
/// cylinder (docs/theory/luminance.md#the-ladder-of-approximations). Errors are those of a lamp in
/// ordinary position, by d/D, its diameter over its distance.
enum class TubeModel {
    automatic, ///< strip up to d/D = 0.018, where its error is 1e-4 at most; cylinder beyond
    picture,   ///< strip up to d/D = 0.2, where its error is 2.3e-3; cylinder beyond
    preview,   ///< as picture, and shadows cut the lamp along its axis alone
    nishita,   ///< [NishitaTubes, eq. 1] with its indices corrected: -0.27 d/D
    rectangle, ///< the facing rectangle, exactly: -0.27 d/D
    line,      ///< the limit of a thin lamp: -0.26 d/D
    strip,     ///< mean-rim strip: -0.058 (d/D)^2, aside and aslant up to 0.28
    cylinder   ///< the tube itself by quadrature: below 1e-9
};

/// Models of the reflection of a row of lamps (docs/theory/luminance.md#in-mirrors).
enum class MirrorModel {
    tube, ///< round tubes in closed form: strips of their apparent width, rims at the ends
    flat, ///< the flat strips of [NishitaTubes]
    exact ///< the capped cylinders; a pixel as the mean over a grid of rays
};

/// The plane of a row of parallel tube lamps (the C-plane of [NishitaTubes]; not a photometric
/// C-plane, whose angle is called c_angle). Lamps lie along u and are spaced along v.
struct CPlane {
    Vec3 origin{0};             ///< corner u = v = 0, mm
    Vec3 u{1000, 0, 0};         ///< edge along the lamps, mm; its length is the lamp length
    Vec3 v{0, 1000, 0};         ///< edge across the lamps, mm; made orthogonal to u on reading
    int lamps = 12;             ///< number of tubes
    double pitch = 0;           ///< mm from axis to axis; 0: |v| / lamps. The row is centred in v
    double diameter = 26;       ///< mm
    Rgb luminance{9000};        ///< cd/m2 of the tube's surface, colour included
    bool luminous_caps = false; ///< true if the tubes' end discs shine like the rest
    TubeModel diffuse = TubeModel::automatic; ///< model for the light on surfaces
    MirrorModel mirror = MirrorModel::tube;   ///< model for reflections

    /// Distance between neighbouring axes, mm.
    double spacing() const { return pitch > 0 ? pitch : v.length() / lamps; }
};

/// A C-plane prepared for computing: unit axes, v orthogonal to u, and the row of lamp axes. Frame
/// coordinates are (u, v, height over the plane) in mm from the corner. A plane without extent has
/// NaN axes: no ray hits it, and it is not visible from any point.
struct CPlaneFrame {
    Vec3 origin, u, v, normal;  ///< corner in mm, and unit axes
    double length = 0;          ///< of the lamps, mm
    double first = 0;           ///< v of the first lamp's axis, mm
    double pitch = 0;           ///< mm
    double diameter = 0;        ///< of the tubes, mm
    int lamps = 0;              ///< number of tubes
    bool luminous_caps = false; ///< as CPlane::luminous_caps

    /// Frame of a C-plane.
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

    /// Radius of a tube, mm.
    double radius() const { return diameter / 2; }
    /// Coordinate v of a lamp's axis, mm; lamps count from 0.
    double axis(int lamp) const { return first + lamp * pitch; }
    /// Coordinate v of the last lamp's axis, mm.
    double last() const { return axis(lamps - 1); }
    /// Frame coordinates of a vector of the world.
    template <class Real>
    Vec3T<Real> vector(const Vec3T<Real>& w) const {
        return {dot(u, w), dot(v, w), dot(normal, w)};
    }
    /// Frame coordinates of a point of the world, mm.
    template <class Real>
    Vec3T<Real> point(const Vec3T<Real>& p) const {
        return vector(p - Vec3T<Real>(origin));
    }
    /// World position of the point (along, across) of the plane.
    Vec3 at(double along, double across) const { return origin + u * along + v * across; }
};

} // namespace keiko
