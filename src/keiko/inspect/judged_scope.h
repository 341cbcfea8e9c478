#pragma once

#include "keiko/base/export.h"
#include "keiko/inspect/basics/face_limits.h"
#include "keiko/inspect/curvature/face_measure.h"
#include "keiko/inspect/seams/seam_measure.h"

#include <cstddef>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// A zone of a preset on a body.
struct ZoneFacts {
    std::string name, selection; ///< as Zone; the selection for people
    std::size_t faces = 0;       ///< placed faces that belong to it
    std::vector<std::string>
        looser; ///< limits that let more pass than the preset's (looser_limits)
    /// Stretches of seams, and faces, in the scope that pass by the limits of the zone and would
    /// not by those of the preset.
    std::size_t excused_seams = 0, excused_faces = 0;
};

/// The judged part of a body, and the zones whose limits it was held to.
struct JudgedScope {
    std::string selection;                ///< Scope::text(); empty: all faces are judged
    std::size_t faces = 0, all_faces = 0; ///< placed faces: those that are judged, and all
    std::size_t seams = 0, all_seams = 0; ///< lines: those that are judged, and all
    std::size_t zoneless = 0;             ///< judged faces that belong to no zone
    std::vector<ZoneFacts> zones{};       ///< in the order of the preset
    std::vector<std::string> outside{};   ///< names of the faces that are not judged
};

/// Takes the stretches without a judged side out of `seams`, numbers the lines of the others
/// anew, and lets the faces that are not judged pass. Returns what is left.
JudgedScope take_scope(const FaceLimits& limits, std::vector<MeasuredSeam>& seams,
                       std::vector<MeasuredFace>& faces);

/// The faces that are judged, and the zones, without seams and without what passes by a zone alone.
JudgedScope scope_of_faces(const SurfaceModel& model, const FaceLimits& limits);

} // namespace keiko
