#pragma once

#include "keiko/base/export.h"
#include "keiko/math/rgb.h"
#include "keiko/radiosity/reflector.h"

#include <span>

namespace KEIKO_API keiko {

/// The light of a solution, lm: what is emitted is absorbed or escapes.
struct EnergyBalance {
    Rgb emitted;  ///< by the elements' own exitance
    Rgb absorbed; ///< by elements
    Rgb escaped;  ///< out of the scene
    /// Emitted light that neither is absorbed nor escapes: 0 for exact radiosities.
    Rgb missing() const { return emitted - absorbed - escaped; }
};

/// Balance of light that arrives at elements from all others, lx. `escaped`: lm/m2 times mm2.
EnergyBalance energy_balance(std::span<const double> areas, std::span<const Reflector> reflectors,
                             std::span<const Rgb> arriving, const Rgb& escaped);

} // namespace keiko
