#pragma once

#include "keiko/geometry/bezier/ray.h"
#include "keiko/light/rig/rig_planes.h"
#include "keiko/render/reflection/cubic_footprint.h"

#include <optional>

namespace keiko {

/// The reflected rays of a pixel's centre and of its neighbours', all with differentials and on one
/// smooth surface.
struct PixelRays {
    Ray centre, left, right, above, below;
};

/// The reflected ray of a part of a pixel.
struct SubpixelRay {
    Vec3 origin, direction;
    RayDifferentials spread;
};

/// A pixel's reflected rays as a cubic in the place in the picture.
class ReflectedFootprint {
public:
    explicit ReflectedFootprint(const PixelRays& rays);
    /// Bounds of the rays of all its parts, itself with them.
    static RayCone bundle(const PixelRays& rays);

    /// The ray of a pixel of `share` times the width and height around a place relative to the
    /// centre, in pixels.
    SubpixelRay part(double x, double y, double share) const;
    /// By how much the rays of neighbours are off the cubic where they pass the plane that the
    /// centre's ray meets at t, mm at the most: large where the surface's curvature jumps.
    double residual(const PixelRays& rays, double t) const;

private:
    /// Origin and direction, or a derivative of them.
    struct Jet {
        Vec3 origin{0}, direction{0};

        Jet operator+(const Jet& o) const { return {origin + o.origin, direction + o.direction}; }
        Jet operator-(const Jet& o) const { return {origin - o.origin, direction - o.direction}; }
        Jet operator*(double s) const { return {origin * s, direction * s}; }
    };
    static Slopes<Jet> slopes_of(const Ray& ray);

    CubicFootprint<Jet> cubic_;
};

/// How far the image of a pixel, or of a part of one, may be off what its own rays tell:
/// footprint_nonlinearity().
constexpr double straight_image = 0.01;
/// Whether a pixel's image is not smooth: neighbours' rays are off what the pixel tells of them by
/// `residual` mm, more than a tenth of the lamps' pitch, or a fiftieth where it is more of what the
/// image spans across the lamps by the centre's `spread`.
bool is_discontinuous(double residual, const RigPlaneHit& plane, const RayDifferentials& spread);
/// A side of a pixel that are made of one whose image is bent so far, 1 to 8; the most where the
/// bend is not a number. Not for negative ones.
int parts_of_bend(double bend);

/// What a pixel sees of the lamps by its reflected rays.
struct PixelMirror {
    MirroredLight lamps;
    std::optional<RigPlaneHit> plane; ///< the nearest that the centre's ray meets
    bool discontinuous =
        false; ///< its image on a C-plane is not smooth: more camera rays are needed
};

/// `centre`: the ray of the pixel's centre. Lamps are seen up to `t_max`. Where the pixel's image
/// on a C-plane is bent, as `around` tells, the mean over as many parts as make each nearly
/// straight. `tells_torn`: whether to find that out.
PixelMirror mirror_of(const RigPlanes& planes, const Ray& centre,
                      const std::optional<PixelRays>& around, double t_max, bool tells_torn);

} // namespace keiko
