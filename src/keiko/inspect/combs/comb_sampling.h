#pragma once

#include "keiko/inspect/basics/patch_lines.h"
#include "keiko/inspect/combs/comb_curves.h"

#include <functional>
#include <optional>

namespace keiko {

/// Curvature of a curve at a place of it on a patch; nullopt if it cannot be computed.
using BendAt = std::function<std::optional<CurveBend>(const SurfaceDerivatives&, const Vec2& uv,
                                                      const Vec3& normal)>;

struct CombSampling {
    double tolerance = 0.01;   ///< as CombOptions::tolerance
    double chord_error = 0.01; ///< mm: distance from poles to which combs extend
    double size = 1;           ///< of the body, mm
};

/// A line's comb: samples at its points and between them, until straight lines between samples are
/// accurate enough. `view` is of the patch's own points.
std::vector<CombSample> comb_samples(const BezierPatchView& view, const ZeroFunction& zeros,
                                     const PatchLine& line, const BendAt& bend,
                                     const CombSampling& sampling);

} // namespace keiko
