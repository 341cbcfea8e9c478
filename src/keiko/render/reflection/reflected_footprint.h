#pragma once

#include "keiko/geometry/visibility/ray.h"
#include "keiko/light/rig/rig_planes.h"

#include <array>
#include <optional>

namespace keiko {

/// Derivatives of a quantity by the picture's x and y, per pixel.
template <class Jet>
struct Slopes {
    Jet x, y; ///< by x, to the right, and by y, down
};

/// A smooth quantity in a picture as a cubic in the place around a pixel's centre: by Taylor's
/// theorem from its value there and its slopes there and at the centres of four neighbours. `Jet`:
/// the value, or a derivative of it; it has +, - and * by a number.
template <class Jet>
class CubicFootprint {
public:
    /// Cubic with the value and the slopes of a pixel's centre, bent by the neighbours' slopes.
    CubicFootprint(const Jet& value, const Slopes<Jet>& centre, const Slopes<Jet>& left,
                   const Slopes<Jet>& right, const Slopes<Jet>& above, const Slopes<Jet>& below)
        : value_(value),
          x_(centre.x),
          y_(centre.y),
          xx_((right.x - left.x) * 0.5),
          xy_((below.x - above.x + right.y - left.y) * 0.25),
          yy_((below.y - above.y) * 0.5),
          xxx_(right.x - x_ * 2 + left.x),
          xxy_(right.y - y_ * 2 + left.y),
          xyy_(below.x - x_ * 2 + above.x),
          yyy_(below.y - y_ * 2 + above.y) {}

    /// Value at a place relative to the centre, in pixels.
    Jet at(double x, double y) const {
        return value_ + x_ * x + y_ * y + xx_ * (x * x / 2) + xy_ * (x * y) + yy_ * (y * y / 2) +
               xxx_ * (x * x * x / 6) + xxy_ * (x * x * y / 2) + xyy_ * (x * y * y / 2) +
               yyy_ * (y * y * y / 6);
    }
    /// Values at the pixel's corners, row by row.
    std::array<Jet, 4> corners() const {
        const Jet even = value_ + (xx_ + yy_) * (1.0 / 8), twisted = xy_ * (1.0 / 4);
        const Jet across = x_ * 0.5 + xxx_ * (1.0 / 48) + xyy_ * (1.0 / 16);
        const Jet along = y_ * 0.5 + yyy_ * (1.0 / 48) + xxy_ * (1.0 / 16);
        const Jet up = even - along, down = even + along;
        return {up + twisted - across, up - twisted + across, down - twisted - across,
                down + twisted + across};
    }
    /// Slopes at a place relative to the centre, in pixels.
    Slopes<Jet> slopes(double x, double y) const {
        return {x_ + xx_ * x + xy_ * y + xxx_ * (x * x / 2) + xxy_ * (x * y) + xyy_ * (y * y / 2),
                y_ + xy_ * x + yy_ * y + xxy_ * (x * x / 2) + xyy_ * (x * y) + yyy_ * (y * y / 2)};
    }

private:
    Jet value_, x_, y_, xx_, xy_, yy_, xxx_, xxy_, xyy_, yyy_;
};

/// The reflected rays of a pixel's centre and of its neighbours', all with differentials and on one
/// smooth surface.
struct PixelRays {
    Ray centre, left, right, above, below; ///< of the pixel and its neighbours
};

/// The reflected ray of a part of a pixel.
struct SubpixelRay {
    Vec3 origin, direction;  ///< world, mm; the direction of any length
    RayDifferentials spread; ///< by the part's own width and height
};

/// A pixel's reflected rays as a cubic in the place in the picture.
class ReflectedFootprint {
public:
    /// Footprint of a pixel by its own rays and the neighbours'; all must have differentials.
    explicit ReflectedFootprint(const PixelRays& rays);
    /// Bounds of the rays of all its parts, itself included.
    static RayCone bundle(const PixelRays& rays);

    /// The ray of a pixel of `share` times the width and height around a place relative to the
    /// centre, in pixels.
    SubpixelRay part(double x, double y, double share) const;
    /// Largest deviation of the neighbours' rays from the cubic, mm, where they pass the plane that
    /// the centre's ray meets at t. It is large where the surface's curvature jumps.
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

/// Largest deviation of the image of a pixel, or of a part of one, from the image by its own rays:
/// footprint_nonlinearity().
constexpr double straight_image = 0.01;
/// True if the reflection is discontinuous across the pixel: the neighbours' rays miss the pixel's
/// cubic by `residual` mm > 10 % of the lamp pitch. A residual > 2 % of the pitch suffices if it is
/// > 5 % of the image's span across the lamps by the centre's `spread`.
bool is_discontinuous(double residual, const RigPlaneHit& plane, const RayDifferentials& spread);
/// Number of parts a side for a pixel whose image has this bend, 1 to 8; 8 if the bend is NaN. Not
/// for negative ones.
int parts_of_bend(double bend);

/// Lamps visible in a pixel by its reflected rays.
struct PixelMirror {
    MirroredLight lamps;              ///< mean over the pixel
    std::optional<RigPlaneHit> plane; ///< the nearest that the centre's ray meets
    /// True if its image on a C-plane is not smooth: more camera rays are needed.
    bool discontinuous = false;
};

/// Lamps in a pixel by `centre`, the ray of its centre; they are visible up to `t_max`. If the
/// pixel's image on a C-plane is bent, by `around`, it is the mean over as many parts as make each
/// nearly straight. `tells_torn`: whether to detect discontinuities.
PixelMirror mirror_of(const RigPlanes& planes, const Ray& centre,
                      const std::optional<PixelRays>& around, double t_max, bool tells_torn);

/// Deviation of the corners of a pixel's image on a C-plane, by the cubic through its reflected
/// rays, from the centre's differentials. It is stated across the lamps, in pitches. If an end of
/// lamps may be in the image, it is also stated along them, as a share of its span. `plane`: the
/// hit of the centre's ray. nullopt if the ray of a corner does not meet it.
std::optional<double> footprint_nonlinearity(const RigPlaneHit& plane, const PixelRays& rays);

} // namespace keiko
