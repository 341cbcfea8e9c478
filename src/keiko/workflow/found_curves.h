#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/model/curve_set.h"
#include "keiko/workflow/check_models.h"
#include "keiko/workflow/find_lines.h"

#include <vector>

namespace KEIKO_API keiko {

/// The curves of a check that was made with these options, as inspection_curves has them, sections
/// and iso-curves among them if any were requested.
CurveSet check_curves(const CheckResult& result, const CheckOptions& options);

/// The contours of the views of a list, hidden ones too, within `chord_error` mm.
std::vector<NamedCurve> view_contours(const Scene& scene, const LineList& list, double chord_error,
                                      const Job& job = {});

} // namespace keiko
