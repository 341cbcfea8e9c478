#pragma once

#include "keiko/light/fog/medium.h"
#include "keiko/light/rig/sun.h"
#include "keiko/light/spotlight/luminaire.h"
#include "keiko/light/spotlight/spotlight.h"
#include "keiko/light/tubes/c_plane.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace keiko {

/// Every kind of light source a rig can hold.
using LightSource = std::variant<CPlane, Spotlight, Luminaire, Sun>;

/// All lights of a scene and the air between them. Placement writes one, every picture reads one.
struct LightRig {
    std::string name;
    std::vector<LightSource> sources;
    Rgb ambient{0}; ///< lx of unshadowed ambient illuminance on every surface
    std::optional<Medium> medium{};
};

} // namespace keiko
