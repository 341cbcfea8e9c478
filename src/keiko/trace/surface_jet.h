#pragma once

#include "keiko/trace/leaf_kernels.h"

namespace keiko {

/// A place of a surface with its first two derivatives; SurfaceDerivatives without what few ask.
struct SurfaceJet {
    Vec3 position{0}, du{0}, dv{0}, duu{0}, duv{0}, dvv{0};

    SurfaceDerivatives derivatives() const;
};

/// By the quotient rule.
SurfaceJet projected(const HomogeneousJet& jet, bool rational);

} // namespace keiko
