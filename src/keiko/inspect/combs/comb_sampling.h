#pragma once

#include "keiko/inspect/basics/patch_lines.h"
#include "keiko/inspect/basics/zero_function.h"
#include "keiko/inspect/combs/comb_curves.h"

#include <functional>
#include <optional>

namespace keiko {

/// How a curve bends at a place of it on a patch; nothing where that cannot be told.
using BendAt = std::function<std::optional<CurveBend>(const SurfaceDerivatives&, const Vec2& uv,
                                                      const Vec3& normal)>;

struct CombSampling {
    double tolerance = 0.01;   ///< as CombOptions has it
    double chord_error = 0.01; ///< mm: this near to poles combs go
    double size = 1;           ///< of the body, mm
};

/// A line's comb: samples at its points and between them, until straight lines between samples are
/// true enough. `view` is of the patch's own points.
std::vector<CombSample> comb_samples(const BezierPatchView& view, const ZeroFunction& zeros,
                                     const PatchLine& line, const BendAt& bend,
                                     const CombSampling& sampling);

} // namespace keiko
