#pragma once

#include "keiko/base/diagnostics.h"
#include "keiko/math/bounds.h"

#include <optional>

namespace keiko {

/// Remark on a body that plainly does not lie in the vehicle frame, which named views assume.
/// The box of such a body is even about x = 0 or z = 0 alone, not about y = 0, the middle plane of
/// a vehicle. It reaches farther to y > 0 than to y < 0, as a body does that stands on y = 0. The
/// entity is the option `axes` (see LoadOptions), and the message suggests one. nullopt for any
/// other box, e.g. those of panels, of half bodies and of bodies that are even about two planes.
std::optional<Diagnostic> axes_remark(const Box3& body);

} // namespace keiko
