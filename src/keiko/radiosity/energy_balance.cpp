#include "keiko/radiosity/energy_balance.h"

#include "keiko/light/luminance/photometry.h"

#include <cstddef>

namespace keiko {

EnergyBalance energy_balance(std::span<const double> areas, std::span<const Reflector> reflectors,
                             std::span<const Rgb> arriving, const Rgb& escaped) {
    EnergyBalance balance{{}, {}, escaped * metres(metres(1))};
    for (std::size_t i = 0; i < areas.size(); ++i) {
        const double area = metres(metres(areas[i])); // m2
        balance.emitted += reflectors[i].exitance * area;
        balance.absorbed += (Rgb(1) - reflectors[i].reflectance) * arriving[i] * area;
    }
    return balance;
}

} // namespace keiko
