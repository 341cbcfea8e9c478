#pragma once

#include "keiko/base/job.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/inspect/seams/seam_measure.h"

#include <array>
#include <span>
#include <vector>

namespace keiko {

/// A bend about a smooth seam, not wider than what is negligible: to a viewer a kink. It may lie
/// beside the seam in one face, across it, or over several faces in a row.
struct NarrowBend {
    PlacedFace face;                   ///< the face that holds the middle of the bend
    std::array<PlacedFace, 2> sides{}; ///< the faces in which it begins and ends
    std::array<PlacedFace, 2> seam{};  ///< the faces of the seam, whose limits it is held to
    double width = 0;                  ///< mm across, between the places whose normals are compared
    double angle = 0;  ///< degrees by which the normal turns more than the curvatures explain
    double length = 0; ///< mm of the seam along which it turns too far
    Vec3 place{0};     ///< world, mm: of the seam, where the angle is largest
};

/// The bends about smooth seams. At places of every piece of a seam the surface is
/// followed square to it, over further smooth seams, up to the negligible length either way.
/// Between two places on that way no farther apart, the normal may turn by what either end's
/// curvature, or none, makes of the way. It is a bend where it turns by more than the limit beyond,
/// and at least twice as far. About a seam that fails by itself it must do so beyond the seam's own
/// angle. From the feature angle on it is a feature line instead. At most one a placed face, on
/// more than the negligible length of a seam. `pieces`: MeasuredSeams::pieces.
std::vector<NarrowBend> narrow_bends(const ModelBorders& borders,
                                     std::span<const MeasuredSeam> seams,
                                     std::span<const Seam> pieces, const FaceLimits& limits,
                                     const Job& job = {});

} // namespace keiko
