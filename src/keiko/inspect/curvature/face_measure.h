#pragma once

#include "keiko/base/job.h"
#include "keiko/inspect/basics/measured_value.h"
#include "keiko/inspect/curvature/face_curvature.h"
#include "keiko/inspect/curvature/inflection_curves.h"
#include "keiko/inspect/flaws/flaw.h"
#include "keiko/inspect/regularity/singular_places.h"
#include "keiko/scene/criteria_preset.h"

#include <optional>
#include <string>
#include <vector>

namespace keiko {

/// Everything known of one placed face by itself, whatever its neighbours are.
struct MeasuredFace {
    std::uint32_t instance = 0, face = 0;
    std::uint32_t id = 0; ///< Face::id
    std::string name;     ///< "face 12 (fender-outer)"; its instance too where there are several
    /// Nothing where the face stands in for one of the file, approximated or at an irregular point
    /// of a cage, whose curvature it does not have; or where trims leave nothing of it.
    std::optional<FaceCurvature> curvature;
    /// The smallest radius of curvature, mm; nothing of a plane. Measured where the preset does not
    /// judge it too; its limit is then 0.
    std::optional<MeasuredValue> radius;
    /// Dents, bumps and waves at least half as deep as the limit, the deepest first; `inspect`
    /// looks for them (find_flaws) where the preset has a limit, judged or not.
    std::vector<Flaw> flaws;
    /// Where it is not regular, the largest angle first; `inspect` searches them (singular_places),
    /// of faces that have a curvature. A fold is judged and fails.
    std::vector<SingularPlace> singular;
    /// Where it turns from bending one way to a saddle, the longest first; not judged. None of a
    /// face that stands in for another.
    std::vector<InflectionCurve> inflections;
    Verdict verdict = Verdict::pass; ///< the worst of all
};

/// Measures and judges every placed face by itself, without flaws, in the order of instances and
/// faces. Throws Cancelled.
std::vector<MeasuredFace> measure_faces(const SurfaceModel& model, const SurfaceLimits& limits,
                                        const Job& job = {});

} // namespace keiko
