#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/model/curve_set.h"
#include "keiko/inspect/combs/comb_curves.h"
#include "keiko/inspect/inspection.h"
#include "keiko/report/content/line_list.h"

#include <span>

namespace KEIKO_API keiko {

// Curves that are found on surfaces, as B-splines for other programs. A cubic spline with
// continuous curvature runs through the found points of each face, and is broken at seams. Where it
// would leave the chords between them by more than three times what the curve does, it is the
// polyline of the points. The deviation adds both distances from the chords.

/// The lines of a list, in its order: each has its number, its verdict and its deviation in its
/// name, and the colour of its verdict. The verdict is the worst of the crossings on it.
CurveSet line_curves(const LineList& list);

/// The sections and iso-curves, sampled to `chord_error` mm, inflection curves of an inspection's
/// faces, and its stretches of seams on their first side, each with its verdict; no scraps.
CurveSet inspection_curves(const Inspection& inspection, std::span<const CombCurve> combs,
                           double chord_error);

} // namespace keiko
