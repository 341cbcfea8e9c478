#include "keiko/maps/orange_peel.h"

#include "keiko/maps/lattice_noise.h"

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

constexpr int waves_a_band = 24; ///< many enough for no direction to be seen

/// A random number from 0 to 1 of a wave.
double random_share(int band, int wave, int which, std::uint32_t seed) {
    return lattice_hash(band, wave, which, seed) / 4294967296.0;
}

Vec3 random_direction(int band, int wave, std::uint32_t seed) {
    const double z = 2 * random_share(band, wave, 0, seed) - 1;
    const double phi = 2 * std::numbers::pi * random_share(band, wave, 1, seed);
    const double r = std::sqrt(1 - z * z);
    return {r * std::cos(phi), r * std::sin(phi), z};
}

} // namespace

OrangePeel::OrangePeel(const std::array<double, 5>& rms, std::uint32_t seed) {
    constexpr double um = 1e-3;
    for (int band = 0; band < 5; ++band) {
        const auto b = static_cast<std::size_t>(band);
        if (!(rms[b] > 0)) continue;
        const double shortest = orange_peel_bands[b], ratio = orange_peel_bands[b + 1] / shortest;
        for (int wave = 0; wave < waves_a_band; ++wave) {
            const double length = shortest * std::pow(ratio, (wave + 0.5) / waves_a_band);
            waves_.push_back({random_direction(band, wave, seed) * (2 * std::numbers::pi / length),
                              2 * std::numbers::pi * random_share(band, wave, 2, seed),
                              rms[b] * um * std::sqrt(2.0 / waves_a_band)});
        }
    }
}

HeightJet OrangePeel::height(const TexturePlace& place) const {
    HeightJet sum;
    constexpr double variance = 1.0 / 12; // of a uniform pixel, by its width squared
    constexpr double weakest = 20;        // leaves 2e-9 of a wave
    for (const Wave& wave : waves_) {
        const double x = wave.k.dot(place.dx), y = wave.k.dot(place.dy);
        const double blur = variance / 2 * (x * x + y * y);
        if (blur > weakest) continue;
        const double amplitude = wave.amplitude * std::exp(-blur);
        const double at = wave.k.dot(place.at) + wave.phase;
        const double sine = amplitude * std::sin(at);
        sum.value += sine;
        sum.gradient += wave.k * (amplitude * std::cos(at));
        for (int i = 0; i < 3; ++i)
            sum.second[static_cast<std::size_t>(i)] -= wave.k * (wave.k[i] * sine);
    }
    return sum;
}

} // namespace keiko
