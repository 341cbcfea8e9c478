#pragma once

#include "keiko/inspect/openings/strand.h"

#include <optional>

namespace keiko {

/// The size of a hole, and the side of its outline on which the faces lie.
struct HoleForm {
    double width = 0;  ///< mm: the least breadth of the outline viewed along its normal
    double length = 0; ///< mm: the breadth at right angles to that
    Vec3 middle{0};    ///< world, mm: the centroid of the outline
    /// Mean cosines, over the outline, of the angle between the outward direction from the middle
    /// and the direction into the face there: the part of positive cosines and, as a positive
    /// number, of negative ones.
    double away = 0, nearer = 0;

    /// True if it is a hole in the faces. At the rim of a tube both means are small. At the border
    /// of a small part only the second is large. At a hole on one side of a sharp crease both are
    /// nearly equal.
    bool is_within_faces() const;
};

/// The form of a closed outline; nullopt if it encloses no area.
std::optional<HoleForm> hole_form(const BoundaryCurves& curves, const FreeEdges& edges,
                                  const Strand& outline);

} // namespace keiko
