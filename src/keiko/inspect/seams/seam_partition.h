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

/// mm: a place at which the class changes is known to this length.
constexpr double class_change_bound = 1e-6;

/// Cuts a piece of a seam where its class changes, as parts in order, at least one. Steps between
/// patch changes are halved while their ends differ in class, or while the angle at their middle
/// leaves the chord between their ends by as much as could carry it over a threshold: an estimate,
/// down to an eighth of the negligible length. A place without normals has the class of its
/// neighbours.
std::vector<SeamPart> partition_seam(const SeamProbe& probe, std::uint32_t piece,
                                     const StretchLimits& limits);

} // namespace keiko
