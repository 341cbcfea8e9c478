#pragma once

#include "keiko/base/job.h"
#include "keiko/inspect/inspection.h"
#include "keiko/scene/symmetry.h"

#include <span>

namespace keiko {

/// Whether the chosen faces of a model, ascending, or all, are nowhere `distance` mm or more from
/// their own mirror image. The worst place is sought, not proved. Throws Cancelled.
bool is_own_image(const SurfaceModel& model, const MirrorPlane& plane, double distance,
                  std::span<const std::uint32_t> chosen = {}, const Job& job = {});

/// Measures how far a body is from its own mirror image, where the preset of its inspection has a
/// limit for it. Adds the check to the inspection, of the face that is furthest from it. Where the
/// preset has a limit for what is worth a review, the plane is found: the first from which the body
/// is less than a fiftieth of its size. The planes tried are y = 0 and those through the middle of
/// the body across y, x or z. The bound is what the nearest points are not proved to; that no place
/// is worse is sought, not proved (docs/theory/inspection.md). Throws Cancelled.
void check_symmetry(const SurfaceModel& model, Inspection& inspection, const Job& job = {});

} // namespace keiko
