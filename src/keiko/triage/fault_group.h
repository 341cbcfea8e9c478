#pragma once

#include "keiko/geometry/model/surface_model.h"
#include "keiko/triage/standing_eyes.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace keiko {

/// Units that are mended together, by their indices.
struct FaultGroup {
    std::vector<std::size_t> units; ///< those of the most weight first
    Sight sight;                    ///< of all of them, at the place of the first
    bool mirrored = false;          ///< it is on both sides of the middle plane
    std::uint32_t patch = no_index; ///< the bad patch on whose seams it lies, into the faces
};

} // namespace keiko
