#include "keiko/maps/lattice_noise.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Mean of the absolute value of lattice noise, from 10^6 places.
constexpr double mean_of_absolute = 0.3297;

double lattice_value(std::int32_t i, std::int32_t j, std::int32_t k, std::uint32_t seed) {
    return lattice_hash(i, j, k, seed) * (2.0 / 4294967296.0) - 1;
}

double quintic(double f) {
    return f * f * f * (f * (f * 6 - 15) + 10);
}

double between(double a, double b, double share) {
    return a + (b - a) * share;
}

/// Calls `add(amplitude, noise, share)` for each octave.
template <class Add>
void each_octave(const Vec3& place, const NoiseOctaves& octaves, double footprint, const Add& add) {
    double amplitude = 1, frequency = 1;
    for (int o = 0; o < octaves.count; ++o) {
        const double share = octave_share(footprint * frequency);
        add(amplitude, share > 0 ? lattice_noise(place * frequency, octaves.seed) : 0, share);
        amplitude *= octaves.gain, frequency *= octaves.lacunarity;
    }
}

} // namespace

std::uint32_t lattice_hash(std::int32_t i, std::int32_t j, std::int32_t k, std::uint32_t seed) {
    std::uint32_t h = static_cast<std::uint32_t>(i) * 0x8DA6B343U ^
                      static_cast<std::uint32_t>(j) * 0xD8163841U ^
                      static_cast<std::uint32_t>(k) * 0xCB1AB31FU ^ seed * 0x9E3779B9U;
    h ^= h >> 16U;
    h *= 0x7FEB352DU;
    h ^= h >> 15U;
    h *= 0x846CA68BU;
    return h ^ h >> 16U;
}

std::int32_t lattice_cell(double coordinate) {
    return static_cast<std::int32_t>(std::floor(std::clamp(coordinate, -2e9, 2e9)));
}

double lattice_noise(const Vec3& place, std::uint32_t seed) {
    constexpr double farthest = 2e9; // beyond, cells have no index
    const Vec3 size = magnitudes(place);
    if (!(std::max({size.x, size.y, size.z}) < farthest)) return 0;
    const std::int32_t i = lattice_cell(place.x), j = lattice_cell(place.y);
    const std::int32_t k = lattice_cell(place.z);
    const double s = quintic(place.x - i), t = quintic(place.y - j), r = quintic(place.z - k);
    const auto row = [&](std::int32_t y, std::int32_t z) {
        return between(lattice_value(i, y, z, seed), lattice_value(i + 1, y, z, seed), s);
    };
    return between(between(row(j, k), row(j + 1, k), t),
                   between(row(j, k + 1), row(j + 1, k + 1), t), r);
}

double NoiseOctaves::total() const {
    double sum = 0, amplitude = 1;
    for (int o = 0; o < count; ++o, amplitude *= gain) sum += amplitude;
    return sum;
}

double octave_share(double footprint) {
    return std::clamp(2 - 2 * footprint, 0.0, 1.0);
}

double fractal_noise(const Vec3& place, const NoiseOctaves& octaves, double footprint) {
    double sum = 0;
    each_octave(place, octaves, footprint, [&](double amplitude, double noise, double share) {
        sum += amplitude * share * noise;
    });
    return sum;
}

double turbulence(const Vec3& place, const NoiseOctaves& octaves, double footprint) {
    double sum = 0;
    each_octave(place, octaves, footprint, [&](double amplitude, double noise, double share) {
        sum += amplitude * between(mean_of_absolute, std::abs(noise), share);
    });
    return sum;
}

} // namespace keiko
