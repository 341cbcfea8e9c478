#pragma once

#include "keiko/base/job.h"
#include "keiko/patch/surface_model.h"

#include <span>

namespace keiko {

/// Boxes of the control points of each face and each part, part coordinates, mm.
struct HullBoxes {
    std::vector<Box3> faces, parts;
};

/// How well a search for the highest place is done.
struct SearchLimits {
    double accuracy = 0; ///< mm: it ends when what is left is no higher than that above the best
    /// Parts that are split before it ends anyway, with a bound that is less tight.
    std::size_t most_parts = 1000000;
};

/// The height along the unit `direction`, mm, that the material of all placed faces does not
/// exceed but for rounding, and comes within the accuracy of; -infinity where there is none.
/// Branch and bound over parts of the model, the one of the largest bound first. The highest place
/// of a face is inside a patch where the gradient of the height vanishes, on a side of a patch
/// where the slope along it does, at a corner, or on a trim curve. So a part of a patch or of a
/// side is left out when its gradient vanishes nowhere, and a stretch of a curve when the height
/// rises or falls all along it. Throws Cancelled.
double highest_place(const SurfaceModel& model, const HullBoxes& hulls, const Vec3& direction,
                     const SearchLimits& limits, const Job& job);

} // namespace keiko
