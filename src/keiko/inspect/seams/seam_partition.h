#pragma once

#include "keiko/inspect/seams/seam_class.h"
#include "keiko/inspect/seams/stretch_limits.h"

#include <vector>

namespace keiko {

/// A part of one piece of a seam, all of one class.
struct SeamPart {
    std::uint32_t piece = 0; ///< index of the probe
    SeamClass kind = SeamClass::smooth;
    SeamPoint begin, end; ///< in the order of side a
    double length = 0;    ///< mm, of side a
    double unknown = 0;   ///< mm of it along which a side has no normal
};

/// mm: error of the position at which the class changes.
constexpr double class_change_bound = 1e-6;

/// Cuts a piece of a seam where its class changes, as parts in order, at least one. Steps between
/// patch changes are halved while their ends differ in class. They are also halved while the angle
/// at their middle deviates from the chord between their ends by enough to carry it over a
/// threshold. This is an estimate, down to an eighth of the negligible length. A place without
/// normals has the class of its neighbours.
std::vector<SeamPart> partition_seam(const SeamProbe& probe, std::uint32_t piece,
                                     const StretchLimits& limits);

} // namespace keiko
