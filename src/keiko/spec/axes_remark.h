#pragma once

#include "keiko/base/diagnostics.h"
#include "keiko/math/bounds.h"

#include <optional>

namespace keiko {

/// Remark on a body that plainly does not lie in the vehicle frame, as named views take it to: its
/// box is even about x = 0 or z = 0 alone, not about y = 0, the middle plane of a vehicle, and
/// reaches farther to y > 0 than to y < 0, as what stands on y = 0 does. Its entity is the option
/// `axes` (see LoadOptions), and its message suggests one. nullopt for any other box: those of
/// panels, of half bodies and of what is even about two planes tell nothing.
std::optional<Diagnostic> axes_remark(const Box3& body);

} // namespace keiko
