#pragma once

#include "keiko/scene/texel_spec.h"
#include "keiko/texels/texel_block.h"

namespace keiko {

/// The block of texels with its fibres, the same on every machine for the same specification
/// (docs/theory/texels.md#fibres).
TexelBlock fibre_block(const TexelSpec& spec);

/// mm, side of the block that repeats.
double block_side(const TexelSpec& spec);

} // namespace keiko
