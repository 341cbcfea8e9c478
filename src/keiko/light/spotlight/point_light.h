#pragma once

#include "keiko/geometry/rays/visibility.h"
#include "keiko/light/luminance/photometry.h"
#include "keiko/light/spotlight/luminaire.h"
#include "keiko/light/spotlight/point_source.h"
#include "keiko/light/spotlight/spotlight.h"

#include <concepts>
#include <vector>

namespace keiko {

/// Parameters in ]0, 1[, sorted, at which a t^2 + 2 b t + c = 0.
std::vector<double> crossings(double a, double b, double c);

/// Parameters in ]0, 1[, sorted, of the crossings of the line p + t w with both nappes of the cone
/// of `half_angle` radians about a unit `axis` through 0. In components along and across the axis
/// the terms of narrow cones do not cancel.
std::vector<double> cone_crossings(const Vec3& p, const Vec3& w, const Vec3& axis,
                                   double half_angle);

/// Parts of a segment inside a spotlight's cone, round or elliptic, parameters 0 to 1
/// (docs/theory/fog.md#lit-parts). Half angles of 90 degrees and more leave a dark cone behind the
/// lamp; 180 and more light all of it.
IntervalSet in_beam(const Spotlight& light, const Segment& segment);

/// Parts of a segment inside the round cone around the axis of a luminaire's angles beyond which
/// its file is dark; all of it for types A and B.
IntervalSet in_beam(const Luminaire& luminaire, const Segment& segment);

/// Parameters of a segment, rising, between which the intensity of a beam is smooth, except where
/// negative q cuts petals and dots off. These are its crossings with the borders and middles of the
/// pattern's periods, with sixths of the hue circle, and with the angles of a table.
std::vector<double> intensity_kinks(const Spotlight& light, const Segment& segment);

/// Kinks of the intensity of a luminaire along a segment; the intensity is linear between the
/// angles of its file.
std::vector<double> intensity_kinks(const Luminaire& luminaire, const Segment& segment);

/// Light without extent; it has a position, `intensity_towards` and `in_beam`.
template <class T>
concept PointLight =
    std::same_as<T, Spotlight> || std::same_as<T, Luminaire> || std::same_as<T, PointSource>;

/// Illuminance in lx at a `point` to which the light is visible, on a surface with unit `normal`; 0
/// from behind (docs/theory/spotlights.md#frame-and-illuminance).
template <PointLight Light>
Rgb illuminance(const Light& light, const Vec3& point, const Vec3& normal) {
    const Vec3 towards = light.position - point;
    const double distance = towards.length();
    return inverse_square_illuminance(intensity_towards(light, point), distance,
                                      normal.dot(towards) / distance);
}

} // namespace keiko
