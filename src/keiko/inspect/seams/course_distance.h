#pragma once

#include "keiko/inspect/seams/seam_measure.h"

namespace keiko {

/// mm: distance of a place from the course of a stretch, less what the course may be off its
/// chords.
double distance_from_course(const MeasuredSeam& seam, const Vec3& place);

} // namespace keiko
