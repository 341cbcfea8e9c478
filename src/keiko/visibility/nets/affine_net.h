#pragma once

#include "keiko/visibility/nets/affine_bounds.h"

namespace keiko {

/// The affine part of a net, and how it bends.
struct AffineNet : AffineBounds {
    /// Second derivatives: middle and half width of their range.
    Vec4 xx{0}, xy{0}, yy{0}, xx_range{0}, xy_range{0}, yy_range{0};
};

AffineNet affine_net(const HomogeneousNet& net);

} // namespace keiko
