#pragma once

#include "keiko/keiko.h"

namespace keiko {

/// The rig that the options name, or else the scene's own. Throws Error without either.
LightRig rig_for_lines(const Scene& scene, const LinesOptions& options);

} // namespace keiko
