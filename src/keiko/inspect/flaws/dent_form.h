#pragma once

#include "keiko/inspect/flaws/reference_form.h"

#include <array>
#include <optional>
#include <span>

namespace keiko {

/// The form under a dent, and how well its surroundings tell it.
struct DentForm {
    ReferenceForm base;
    double bound = 0; ///< mm: how far its height at the origin may be off, an estimate
};

/// How far around a dent its form is fitted, as shares of half a window's width: the roots of 8,
/// 12, 19 and 31 rings of samples out of 12.
constexpr std::array<double, 4> dent_reaches{0.8165, 1, 1.2583, 1.6073};

/// Fits the form to heights as far as each of the reaches (`half_window` mm times the shares
/// above), of either kind, and takes the fit that has the least bound. A dent that fills most of
/// the narrow ones does not of the wide ones; what else stands around is in the wide ones alone.
/// The bound is by how much the height at the origin changes from the next narrower fit, or leaves
/// the bounds of a wider one, and what the scatter about the fit makes of it. Nothing where no two
/// of a kind can be fitted.
std::optional<DentForm> dent_form(std::span<const Height> heights, double half_window);

} // namespace keiko
