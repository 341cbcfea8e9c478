#pragma once

#include "keiko/base/export.h"
#include "keiko/base/job.h"
#include "keiko/inspect/basics/verdict.h"
#include "keiko/inspect/curvature/face_curvature.h"
#include "keiko/inspect/curvature/inflection_curves.h"
#include "keiko/inspect/flaws/flaw_search.h"
#include "keiko/inspect/regularity/singular_places.h"
#include "keiko/scene/criteria_preset.h"

#include <optional>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// Measurements of one placed face by itself, independent of its neighbours.
struct MeasuredFace {
    std::uint32_t instance = 0, face = 0; ///< into the model's arrays
    std::uint32_t id = 0;                 ///< Face::id
    std::string name; ///< "face 12 (fender-outer)"; with its instance if there are several
    /// Extremes of curvature. nullopt if trims leave no material of the face. Also nullopt if it is
    /// an approximation of a face of the file, or lies at an irregular point of a cage: its
    /// curvature then differs from the true one.
    std::optional<FaceCurvature> curvature;
    /// The smallest radius of curvature, mm; nullopt for a plane. It is measured even if the preset
    /// does not judge it; its limit is then 0.
    std::optional<MeasuredValue> radius;
    /// Dents, bumps and waves at least half as deep as the limit, the deepest first. `inspect`
    /// searches them (find_flaws) if the preset has a limit, judged or not.
    std::vector<Flaw> flaws;
    /// Places at which the face is not regular, the largest angle first. `inspect` searches them
    /// (singular_places) on faces that have a curvature. A fold is judged and fails.
    std::vector<SingularPlace> singular;
    /// Curves along which the face turns from convex or concave to a saddle, the longest first; not
    /// judged. Empty for a face that replaces another.
    std::vector<InflectionCurve> inflections;
    Verdict verdict = Verdict::pass; ///< the worst of all its verdicts
};

/// Measures and judges every placed face by itself, without flaws, in the order of instances and
/// faces. Throws Cancelled.
std::vector<MeasuredFace> measure_faces(const SurfaceModel& model, const SurfaceLimits& limits,
                                        const Job& job = {});

} // namespace keiko
