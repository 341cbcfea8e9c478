#pragma once

#include "keiko/geometry/visibility/visibility.h"
#include "keiko/light/fog/medium.h"
#include "keiko/light/luminance/photometry.h"

#include <vector>

namespace keiko {

/// Extinction in 1/m at a point.
Rgb extinction_at(const Medium& medium, const Vec3& point);

/// The integral of the extinction along a segment, by channel; exact up to rounding
/// (docs/theory/fog.md#layers, docs/theory/fog.md#grids).
Rgb optical_depth(const Medium& medium, const Segment& segment);

/// Parameters of the segment, rising, between which the extinction along it is smooth.
std::vector<double> density_breaks(const Medium& medium, const Segment& segment);

/// Share of light, by channel 0 to 1, that passes an optical depth unscattered.
Rgb transmittance(const Rgb& optical_depth);

/// The same of a segment.
Rgb transmittance(const Medium& medium, const Segment& segment);

/// Luminance in cd/m2 that the medium's own ambient light adds over an optical depth: Ja (1 - T).
Rgb ambient_inscatter(const Medium& medium, const Rgb& optical_depth);

} // namespace keiko
