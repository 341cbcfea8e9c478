#pragma once

#include "keiko/light/rig/light_rig.h"

#include <string>
#include <vector>

namespace keiko {

/// A name for each source of a rig by its kind and its number among them from 0: "c_plane.0",
/// "c_plane.1", "spotlight.0".
std::vector<std::string> source_columns(const LightRig& rig);

} // namespace keiko
