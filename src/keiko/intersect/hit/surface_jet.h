#pragma once

#include "keiko/intersect/kernels/sub_patch_kernels.h"

#include <optional>

namespace keiko {

/// A place of a surface with its first two derivatives; SurfaceDerivatives without what few ask.
struct SurfaceJet {
    Vec3 position{0};            ///< mm
    Vec3 du{0}, dv{0};           ///< first derivatives by the parameters, mm
    Vec3 duu{0}, duv{0}, dvv{0}; ///< second derivatives by the parameters, mm

    /// SurfaceDerivatives of these numbers, with zeros for every higher derivative.
    SurfaceDerivatives derivatives() const;
};

/// Point and derivatives of a homogeneous jet in space. A rational jet is projected by the quotient
/// rule; without `rational` the weight counts as constant and only scales. Requires a weight other
/// than 0.
SurfaceJet projected(const HomogeneousJet& jet, bool rational);

/// Unit normal, where a surface is seen edge-on, to the side to which it bends along the way there:
/// from which that is seen. Nothing next to where that changes, a cusp.
std::optional<Vec3> bending_side(const SurfaceJet& place, const Vec3& way);

} // namespace keiko
