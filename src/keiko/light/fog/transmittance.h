#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/rays/visibility.h"
#include "keiko/light/fog/medium.h"
#include "keiko/light/luminance/photometry.h"

#include <span>
#include <vector>

namespace KEIKO_API keiko {

/// Extinction in 1/m at a point.
Rgb extinction_at(const Medium& medium, const Vec3& point);

/// The integral of the extinction along a segment, by channel; exact up to rounding
/// (docs/theory/fog.md#layers, docs/theory/fog.md#grids).
Rgb optical_depth(const Medium& medium, const Segment& segment);

/// Parameters of the segment, rising, between which the extinction along it is smooth.
std::vector<double> density_breaks(const Medium& medium, const Segment& segment);

/// Share of light, by channel 0 to 1, that passes an optical depth unscattered.
Rgb transmittance(const Rgb& optical_depth);

/// Share of light, by channel 0 to 1, that passes a segment of the medium unscattered.
Rgb transmittance(const Medium& medium, const Segment& segment);

/// Luminance in cd/m2 that the medium's own ambient light adds over an optical depth: Ja (1 - T).
Rgb ambient_inscatter(const Medium& medium, const Rgb& optical_depth);

/// A lit part of a camera ray split into smooth pieces, as parameters of the ray.
std::vector<double> smooth_pieces(const ParameterInterval& part, std::span<const double> breaks);

/// The optical depth from the camera along a ray, precomputed up to the breaks of the medium's
/// density, so that one more point costs at most one piece.
class AttenuatedRay {
public:
    /// Keeps references to both.
    AttenuatedRay(const Medium& medium, const Segment& ray);

    /// The medium, as given.
    const Medium& medium() const { return medium_; }
    /// The ray, as given.
    const Segment& ray() const { return ray_; }

    /// Optical depth from the camera to a parameter of the ray.
    Rgb depth_to(double t) const;
    /// Parameters of the ray, rising, between which the extinction is smooth.
    const std::vector<double>& breaks() const { return breaks_; }

private:
    const Medium& medium_;
    const Segment& ray_;
    std::vector<double> breaks_;
    std::vector<Rgb> depths_; ///< at the breaks
    /// Depth of the whole ray if all of it had the density between two breaks, where that is
    /// uniform: by the number of breaks before. Empty if it is not.
    std::vector<Rgb> even_;
};

} // namespace keiko
