#pragma once

#include "keiko/base/error.h"
#include "keiko/light/rig/light_rig.h"

namespace keiko {

/// The flux_contradictions of a rig's luminaires, once for each file.
Diagnostics luminaire_remarks(const LightRig& rig);

} // namespace keiko
