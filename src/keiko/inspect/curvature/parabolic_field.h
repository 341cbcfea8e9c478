#pragma once

#include "keiko/geometry/bernstein/bernstein_field.h"
#include "keiko/geometry/bezier/bezier.h"
#include "keiko/inspect/basics/placed_face.h"

#include <optional>
#include <vector>

namespace keiko {

/// A side of a patch's parameters along which its Gaussian curvature is 0.
struct ParabolicSide {
    bool by_u = true;   ///< u is fixed, else v
    bool upper = false; ///< at 1, else at 0
    int sign = 0;       ///< of the Gaussian curvature beside it; 0 where that changes along it
};

/// A field with the sign of a patch's Gaussian curvature. `inner` has that sign everywhere inside;
/// the curvature is 0 on `sides`, where patches of revolution and of fillets often end.
struct ParabolicField {
    BernsteinField inner;             ///< polynomial in the patch's own parameters
    std::vector<ParabolicSide> sides; ///< at most four
};

/// The field from the numerator of the Gaussian curvature in Bernstein form, exact to within
/// rounding (docs/theory/inspection.md). It is nullopt if the curvature is 0 to within rounding, as
/// on developable patches, or cannot change its sign, as on ruled ones.
std::optional<ParabolicField> parabolic_field(const BezierPatchView& patch, double rounding);

/// Rate, in 1/mm a mm, at which the principal curvature that is 0 changes across a parabolic curve
/// at a place of it; 0 if the place is singular or planar. Needs derivatives to order 3.
double parabolic_rate(const SurfaceDerivatives& s);

} // namespace keiko
