#pragma once

#include "keiko/base/error.h"
#include "keiko/base/export.h"
#include "keiko/base/job.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/scene/analysis.h"

#include <cstdint>
#include <vector>

namespace KEIKO_API keiko {

/// An analysis on a body: faces and places are those of the body.
struct FollowedAnalysis {
    Analysis analysis;     ///< hidden faces that are not there are left out; lost notes stay
    Diagnostics remarks{}; ///< what could not be followed

    /// The hidden faces, as Face::id, ascending.
    std::vector<std::uint32_t> hidden() const;
};

/// The analysis on a body, which may be another revision of the one that it was made on. A hidden
/// face is followed by its name; where no face has the name, or several do, by its place. A note is
/// followed to the nearest place of the body. Places are followed over a hundredth of the body's
/// size. Throws Cancelled.
FollowedAnalysis followed_analysis(Analysis analysis, const SurfaceModel& body,
                                   const Job& job = {});

/// Hidden faces by Face::id, with the names and places by which they are followed. Ids that no face
/// has are left out. Throws Cancelled.
std::vector<HiddenFace> hidden_faces(const SurfaceModel& body,
                                     const std::vector<std::uint32_t>& ids, const Job& job = {});

} // namespace keiko
