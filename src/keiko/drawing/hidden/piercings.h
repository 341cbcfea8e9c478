#pragma once

#include "keiko/base/job.h"
#include "keiko/drawing/curves/model_curve.h"
#include "keiko/intersect/traversal/tracer.h"

#include <vector>

namespace keiko {

/// The curves with ModelCurve::piercings: where bodies interpenetrate, their edges pass through
/// surfaces. A surface that a curve touches without passing through a chord of it is left out, and
/// so are places at the ends of a curve, where other faces meet it. Throws Cancelled.
std::vector<ModelCurve> find_piercings(std::vector<ModelCurve> curves, const Tracer& tracer,
                                       const Job& job = {});

} // namespace keiko
