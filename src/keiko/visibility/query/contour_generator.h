#pragma once

#include "keiko/visibility/boundaries/boundary_piece.h"
#include "keiko/visibility/silhouettes/silhouette_candidates.h"

#include <optional>
#include <vector>

namespace keiko {

/// The line along which a viewpoint sees a silhouette candidate edge-on, from one side of its piece
/// to another. It has one or two straight stretches between exact places: two where it may run back
/// along `along`. `inward`: to the side that the surface hides. None where the line of the
/// candidate's affine part does not cross the piece, nothing where Newton's method does not find
/// its ends.
std::optional<std::vector<BoundaryPiece>> contour_generator(const Silhouettes& silhouettes,
                                                            const SubPatchKernels& kernels,
                                                            const SilhouetteCandidate& candidate,
                                                            const Viewpoint& viewpoint,
                                                            const Vec3& along);

} // namespace keiko
