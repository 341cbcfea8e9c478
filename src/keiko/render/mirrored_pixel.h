#pragma once

#include "keiko/render/spot_grid.h"
#include "keiko/rig/rig_planes.h"

#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// A pixel's mirrored rays as a cubic in the place in the picture: by Taylor's theorem from the
/// ray of the centre and the differentials there and at the centres of four neighbours.
class MirroredPixel {
public:
    /// All with differentials and on one smooth surface.
    MirroredPixel(const Ray& centre, const Ray& left, const Ray& right, const Ray& above,
                  const Ray& below);

    /// The ray at a place relative to the centre, in pixels, without differentials.
    Ray ray(double x, double y) const;
    /// The same, with the differentials there of a pixel of `share` times the width and height.
    Ray ray(double x, double y, double share) const;
    /// By how much the neighbours' rays are off the cubic where they pass the plane that the
    /// centre's ray meets at t, mm at the most: large where the surface's curvature jumps.
    double misfit(double t) const { return misfit_.origin + t * misfit_.direction; }

private:
    /// Origin and direction, or a derivative of them.
    struct Jet {
        Vec3 origin{0}, direction{0};

        Jet operator+(const Jet& o) const { return {origin + o.origin, direction + o.direction}; }
        Jet operator-(const Jet& o) const { return {origin - o.origin, direction - o.direction}; }
        Jet operator*(double s) const { return {origin * s, direction * s}; }
    };
    static Jet by_x(const Ray& ray);
    static Jet by_y(const Ray& ray);
    void compare(const Ray& neighbour, double x, double y);

    struct {
        double origin = 0, direction = 0;
    } misfit_;
    Jet value_, x_, y_, xx_, xy_, yy_, xxx_, xxy_, xyy_, yyy_;
};

/// The mirrored rays of a grid of eye rays.
class MirroredGrid {
public:
    /// Of `width` rays in a row, which met `spots` first.
    MirroredGrid(int width, std::span<const LitSpot> spots);

    /// Keeps the mirrored ray of an eye ray, which is only looked at.
    void set(std::size_t sample, const Ray& mirrored) { rays_[sample] = &mirrored; }
    /// Nothing beside the grid's border and where the neighbours show something else.
    std::optional<MirroredPixel> pixel(std::size_t sample) const;

private:
    SpotGrid spots_;
    std::vector<const Ray*> rays_;
};

/// What a pixel sees of the lamps by its mirrored rays.
struct PixelMirror {
    MirroredLight lamps;
    bool torn = false; ///< its image on a C-plane is not smooth: more eye rays are needed
};

/// `centre`: the ray of the pixel's centre. Lamps are seen up to `t_max`. Where the pixel's image
/// on a C-plane is bent, the mean over as many parts as make each nearly straight.
PixelMirror mirror_of(const RigPlanes& planes, const Ray& centre,
                      const std::optional<MirroredPixel>& pixel, double t_max);

} // namespace keiko
