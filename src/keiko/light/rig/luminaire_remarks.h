#pragma once

#include "keiko/base/error.h"
#include "keiko/base/export.h"
#include "keiko/light/rig/light_rig.h"
#include "keiko/light/spotlight/photometric_web.h"

#include <string>

namespace KEIKO_API keiko {

/// Warnings for figures of a luminaire file's header that its intensities contradict by more than
/// 1 % of the flux. They are a light output ratio, a share of downward flux, and lamps with less
/// flux than the luminaire. Each warning names the file and both numbers.
Diagnostics flux_contradictions(const std::string& file, const PhotometricWeb& web);

/// The flux_contradictions of a rig's luminaires, once for each file.
Diagnostics luminaire_remarks(const LightRig& rig);

} // namespace keiko
