#pragma once

#include "keiko/inspect/openings/strand.h"

#include <optional>

namespace keiko {

/// The size of a hole, and on which side of its outline the faces lie.
struct HoleForm {
    double width = 0;  ///< mm: the least breadth of the outline as seen along its normal
    double length = 0; ///< mm: the breadth at right angles to that
    Vec3 middle{0};    ///< world, mm: the centroid of the outline
    /// Mean cosines, over the outline, of the angle between the way out from the middle and that
    /// into the face there: the share of positive ones and, as a positive number, of negative ones.
    double away = 0, nearer = 0;

    /// Whether it is a hole of the faces. The rim of a tube has neither share, the border of a
    /// small part only the second, and a hole on one side of a sharp crease nearly as much of
    /// either.
    bool is_within_faces() const;
};

/// The form of a closed outline; nothing where it encloses no area.
std::optional<HoleForm> hole_form(const BoundaryCurves& curves, const FreeEdges& edges,
                                  const Strand& outline);

} // namespace keiko
