#pragma once

#include "keiko/math/vec.h"

#include <span>

namespace keiko {

/// Unit direction of phi = 0 of a lamp whose axis has turned through `ways`, from one to the next
/// in a plane. Parallel transport carries it along (docs/theory/spotlights.md#moving-axes), so that
/// the pattern does not flip where the axis passes `reference`. `ways`: at least one, none of no
/// length.
Vec3 carried_reference(const Vec3& reference, std::span<const Vec3> ways);

} // namespace keiko
