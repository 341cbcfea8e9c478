#pragma once

#include "keiko/geometry/trim/trim_region.h"
#include "keiko/visibility/boundaries/boundary_piece.h"
#include "keiko/visibility/boundaries/segment_plane.h"

#include <span>
#include <vector>

namespace keiko {

/// Appends the events at which a border, seen from the viewpoint of `plane`, crosses its segment:
/// the zeros of m.(C(t) - P) (docs/theory/visibility.md#events). `regions` are those of the model's
/// faces.
void find_border_events(const BoundaryPiece& border, std::span<const TrimRegion> regions,
                        const SegmentPlane& plane, std::vector<VisibilityEvent>& events);

} // namespace keiko
