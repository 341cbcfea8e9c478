#pragma once

#include "keiko/base/export.h"
#include "keiko/inspect/check.h"

#include <string_view>

namespace KEIKO_API keiko {

/// Kinds of mending, by the property of the surface that is at fault, in the order in which they
/// are done: borders that do not meet have no angle to close.
enum class Mending {
    position,  ///< borders that do not meet
    tangent,   ///< a jump of the normal
    curvature, ///< a jump of the curvature, a dent or a wave
    layout     ///< the structure of patches and faces
};

/// "position", "tangent", "curvature", "layout"
std::string_view name_of(Mending mending);

/// The mending that a finding asks for, by its code.
Mending mending_of(const Check& check);

} // namespace keiko
