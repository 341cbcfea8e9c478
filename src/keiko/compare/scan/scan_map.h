#pragma once

#include "keiko/compare/scan/scan_deviation.h"
#include "keiko/compare/shape/deviation_map.h"

namespace keiko {

/// How far around a place of the surface a map takes points, mm: 1.5 times their spacing, but at
/// least a 500th of the size of the nominal.
double map_radius(std::span<const PointDeviation> points, double nominal_size);

/// Deviation of a scan on the nominal surface, as viewed by an eye: each pixel has the mean of the
/// measured points whose closest points lie within `radius` mm of its place. No number where there
/// is none. The same for any number of threads. Reports stage "deviation map". Throws Cancelled.
DeviationMap scan_map(const Tracer& nominal, const Camera& camera,
                      std::span<const PointDeviation> points, double radius, const Job& job = {});

} // namespace keiko
