#pragma once

namespace keiko {

/// Arc minutes: the finest detail that an eye resolves, by the definition of visual acuity 1.0
/// (ISO 8596).
constexpr double eye_resolution = 1;

/// Arc minutes: width below which the reflection of a lamp becomes a line to an eye.
constexpr double stripe_width = 5 * eye_resolution;

/// How an eye sees a place of a body.
struct LineOfSight {
    double distance = 0; ///< mm, from the eye to the place
    double cosine = 0;   ///< between the line and the normal, 0 to 1
};

/// Arc minutes: width of the reflected lamp from the place of the body, a tube of 60 mm at 2 m.
constexpr double lamp_width = 103.1;

/// Size in which the eye sees the reflection of a distant lamp, over that on a plane:
/// 1 / (1 + 2 k d / c). `curvature` in 1/mm, in the plane of incidence, above 0 where the surface
/// bulges towards the eye. Below 0 behind the focus of a hollow place, where the reflection is
/// upside down; at most `largest_image` either way. Derivation: docs/theory/triage.md.
double image_size(double curvature, const LineOfSight& sight);
/// Limit of image_size(): towards the focus of a hollow place lamps dissolve into one colour.
constexpr double largest_image = 1;

/// Arc minutes by which the reflection of a distant lamp is torn apart where the normal turns by
/// `angle` degrees, seen from the eye. `curvature` as in image_size(). 0 at grazing incidence.
double break_of_angle(double angle, double curvature, const LineOfSight& sight);

/// Arc minutes by which the reflection of a lamp of `lamp_width` changes where the curvature jumps
/// from `a` to `b`, as in image_size(). Its width changes; where it turns over, both widths add up.
/// Where the smaller image is narrower than stripe_width, the change counts by the square of that
/// share: beside a fillet, which shrinks lamps to a line, there is no stripe that changes.
double break_of_curvatures(double a, double b, const LineOfSight& sight);

/// A change of a stripe's width is as sure to an eye as a tear by this part of it
/// (docs/theory/triage.md).
constexpr double offsets_a_change = 12;

/// Exponent by which an eye pools breaks along a line (docs/theory/triage.md). It is as sure of a
/// short sharp one as of a long faint one if their integrals to this power are equal.
constexpr double pooling = 3;
/// Arc minutes: length along which a break counts in full.
constexpr double pooling_length = 60;

/// The share of a pooled integral of a break of `width` along `length`, both arc minutes.
double pooled(double width, double length);
/// Arc minutes: the break along pooling_length that has this integral.
double break_of_pooled(double integral);

/// Arc minutes of a gap of `gap` mm, seen squarely.
double break_of_gap(double gap, const LineOfSight& sight);

/// Arc minutes that a gap counts as which is as bad as `angle` degrees, whatever the curvature:
/// half of the tear by that angle on a plane, and a lamp's width at most.
double break_of_gap_angle(double angle);

} // namespace keiko
