#pragma once

#include "keiko/base/job.h"
#include "keiko/inspect/structure/face_structure.h"

#include <map>
#include <optional>

namespace keiko {

/// How the edges of a face are put together from the curves of its borders. Each value is measured,
/// and judged, if the limits have one for it.
struct EdgeStructure {
    std::optional<MeasuredValue> gap;           ///< mm; nullopt without two edges in a loop
    std::optional<MeasuredValue> angle;         ///< degrees; nullopt if no edge has two curves
    std::optional<MeasuredValue> degree;        ///< nullopt without edges
    std::optional<MeasuredValue> knot_distance; ///< mm; nullopt if no edge has two curves
};

/// The edges of every placed face in `limits`, each face by its own; faces without edges are left
/// out (docs/theory/structure.md). Throws Cancelled.
std::map<FaceKey, EdgeStructure> edge_structures(const ModelBorders& borders,
                                                 const std::map<FaceKey, StructureLimits>& limits,
                                                 const Job& job = {});

} // namespace keiko
