#pragma once

#include "keiko/base/job.h"
#include "keiko/drawing/curves/model_curve.h"
#include "keiko/inspect/basics/line_field.h"

#include <vector>

namespace keiko {

/// The outlines of a body in one view: contour generators n.v = 0 of its trimmed faces, patch by
/// patch.
struct Outlines {
    std::vector<ModelCurve> curves;        ///< to be drawn
    std::vector<OccludingCurve> occluding; ///< the same curves: two sheets end at each
};

/// Finds the outlines of a body. `chord_error` in mm. The curves keep a reference to the model.
/// Throws Cancelled.
Outlines find_outlines(const SurfaceModel& model, const LineEye& eye, double chord_error,
                       const Job& job = {});

} // namespace keiko
