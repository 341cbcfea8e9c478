#pragma once

#include "keiko/inspect/flaws/form_polynomial.h"

#include <optional>
#include <span>

namespace keiko {

/// A place of a surface beside a tangent plane, mm, and its weight.
struct FormHeight {
    double x = 0;      ///< mm, in the plane from its origin
    double y = 0;      ///< mm, in the plane, square to x
    double z = 0;      ///< mm, from the plane along its normal
    double weight = 1; ///< factor of its square in the fit's sum
};

/// Smooth forms of a ReferenceForm, by what is a polynomial of the place in the plane.
enum class FormKind {
    flat, ///< the height z
    bent ///< z - b z² / 2, with the larger curvature b at the origin: exact for spheres, cylinders
};

/// The form under a dent: a polynomial of total degree 4 over the plane through most heights.
/// Outliers do not count. It is fitted by iteratively reweighted least squares, first to the
/// smallest sum of distances, then with Tukey's biweight [HollandWelsch1977], as [ISO16610-31] does
/// for profiles.
class ReferenceForm {
public:
    /// The form of the heights within `reach` of the origin, mm; nullopt if they are fewer than
    /// twice the terms or, on a disc, too close to a line.
    static std::optional<ReferenceForm> fit(std::span<const FormHeight> heights, double reach,
                                            FormKind kind = FormKind::flat,
                                            FormDomain domain = FormDomain::disc);

    /// mm: deviation of a height from the form, along the normal of the plane near the origin.
    double offset(const FormHeight& height) const;
    /// mm: height of the form above the plane at the origin.
    double at_origin() const { return terms_[0]; }
    double reach() const { return reach_; } ///< mm
    /// mm: estimated error of the form's height at the origin. It is the root of the mean square
    /// distance of the heights that count, times the fit's Lebesgue constant, which is large where
    /// a gap or a side has no heights.
    double origin_bound() const { return origin_bound_; }

private:
    double levelled(double z) const { return z - bend_ / 2 * z * z; }

    double reach_ = 1, origin_bound_ = 0;
    double bend_ = 0; ///< 1/mm, 0 of a flat one
    FormDomain domain_ = FormDomain::disc;
    FormTerms terms_{};
};

} // namespace keiko
