#pragma once

#include "keiko/maps/texture_place.h"

#include <array>
#include <cstdint>
#include <vector>

namespace keiko {

/// Height with its gradient and second derivatives in space.
struct HeightJet {
    double value = 0; ///< mm
    Vec3 gradient{0}; ///< mm a unit of the coordinates
    /// Rows of the symmetric matrix of second derivatives.
    std::array<Vec3, 3> second{Vec3(0), Vec3(0), Vec3(0)};

    /// Times a factor.
    HeightJet operator*(double factor) const {
        return {value * factor,
                gradient * factor,
                {second[0] * factor, second[1] * factor, second[2] * factor}};
    }
    /// Sum of both.
    HeightJet operator+(const HeightJet& o) const {
        return {value + o.value,
                gradient + o.gradient,
                {second[0] + o.second[0], second[1] + o.second[1], second[2] + o.second[2]}};
    }
    /// Second derivative along two directions.
    double along(const Vec3& a, const Vec3& b) const {
        return a.dot(Vec3(second[0].dot(b), second[1].dot(b), second[2].dot(b)));
    }
};

/// Bands of wavelength in mm, by which instruments divide the waviness of paint: Wa 0.1 to 0.3, Wb
/// 0.3 to 1, Wc 1 to 3, Wd 3 to 10, We 10 to 30 [BYKwavescan].
constexpr std::array<double, 6> orange_peel_bands{0.1, 0.3, 1, 3, 10, 30};

/// Waviness of paint: a sum of sines of random directions in space and phases, of wavelengths that
/// are spread over each band by equal ratios.
class OrangePeel {
public:
    /// Waves with these rms heights, um, by band.
    OrangePeel(const std::array<double, 5>& rms, std::uint32_t seed);

    /// Height at a place, mm, in the mean over the pixel: each wave as much weaker as a Gaussian of
    /// the pixel's variance makes it.
    HeightJet height(const TexturePlace& place) const;

private:
    struct Wave {
        Vec3 k; ///< 2 pi over the wavelength, along its direction, 1/mm
        double phase, amplitude;
    };
    std::vector<Wave> waves_;
};

} // namespace keiko
