#pragma once

#include "keiko/inspect/flaws/reference_form.h"

#include <array>
#include <optional>
#include <span>

namespace keiko {

/// The form under a dent, and the accuracy to which its surroundings determine it.
struct DentForm {
    ReferenceForm base;
    double bound = 0; ///< mm: estimated error of its height at the origin
};

/// Radii around a dent within which its form is fitted, as shares of half a window's width: the
/// roots of 8, 12, 19 and 31 rings of samples out of 12.
constexpr std::array<double, 4> dent_reaches{0.8165, 1, 1.2583, 1.6073};

/// Fits the form of either kind to heights within each of the reaches (`half_window` mm times the
/// shares above), and takes the fit with the least bound. A dent that fills most of the narrow
/// reaches does not fill the wide ones; other features around it lie in the wide ones alone. The
/// bound is the change of the height at the origin from the next narrower fit, or its distance from
/// the bounds of a wider one, with the effect of the scatter about the fit. It is nullopt if no two
/// of a kind can be fitted.
std::optional<DentForm> dent_form(std::span<const FormHeight> heights, double half_window);

} // namespace keiko
