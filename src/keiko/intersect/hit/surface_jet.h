#pragma once

#include "keiko/intersect/kernels/sub_patch_kernels.h"

#include <optional>

namespace keiko {

/// A place of a surface with its first two derivatives; SurfaceDerivatives without what few ask.
struct SurfaceJet {
    Vec3 position{0}, du{0}, dv{0}, duu{0}, duv{0}, dvv{0};

    SurfaceDerivatives derivatives() const;
};

/// By the quotient rule.
SurfaceJet projected(const HomogeneousJet& jet, bool rational);

/// Unit normal, where a surface is seen edge-on, to the side to which it bends along the way there:
/// from which that is seen. Nothing next to where that changes, a cusp.
std::optional<Vec3> bending_side(const SurfaceJet& place, const Vec3& way);

} // namespace keiko
