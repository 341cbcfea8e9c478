#pragma once

#include "keiko/base/export.h"
#include "keiko/inspect/inspection.h"
#include "keiko/inspect/seams/seam_profile.h"

#include <span>
#include <string>

namespace KEIKO_API keiko {

/// keiko-profiles/1: every profile with its stretch, its largest values, limits, shares beyond them
/// and samples.
std::string profiles_json(std::span<const SeamProfile> profiles, const Inspection& inspection,
                          const std::string& tool_version);

/// CSV with a header, then a row a sample, with the limits and shares of its stretch.
std::string profiles_csv(std::span<const SeamProfile> profiles, const Inspection& inspection);

/// The SVG plots of a profile for a page, one above the other. They show gap, angle, the curvatures
/// of both sides and their mismatch, and the change of their slope if it has a limit.
/// Limits are lines, what is beyond them is shaded. Colours are those of the page.
std::string profile_svg(const SeamProfile& profile, CurvatureFormula formula);

} // namespace keiko
