#pragma once

#include "keiko/base/export.h"
#include "keiko/math/affine.h"

#include <string_view>

namespace KEIKO_API keiko {

/// The turn of a file's coordinates into the vehicle frame. `axes` names the axes of the file that
/// point rearwards, to the right and up, with a minus where it is their other end. For example
/// "x,-z,y" is a file whose y is up and whose z is to the left. Throws Error for other words, an
/// axis named twice, and axes that would mirror the body.
Affine axes_frame(std::string_view axes);

} // namespace keiko
