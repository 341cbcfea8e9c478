#include "keiko/maps/patterns.h"

#include <array>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

/// Share of [0, x] that lies in intervals [n + low, n + high] with whole n; 0 <= low <= high <= 1.
double pulses_up_to(double x, double low, double high) {
    const double n = std::floor(x);
    return n * (high - low) + std::clamp(x - n - low, 0.0, high - low);
}

/// Mean over `width` around x of 1 in the intervals [n + low, n + high] and 0 between.
double pulses(double x, double width, double low, double high) {
    constexpr double narrowest = 1e-9; // below which the difference is one of rounding
    const double rest = x - std::floor(x);
    if (!(width > narrowest)) return rest >= low && rest < high ? 1 : 0;
    return (pulses_up_to(rest + width / 2, low, high) - pulses_up_to(rest - width / 2, low, high)) /
           width;
}

/// Mean over `width` of a sine with period 1, relative to its middle.
double sine_share(double width) {
    const double x = std::numbers::pi * width;
    return x < 1e-4 ? 1 : std::max(std::sin(x) / x, 0.0) * octave_share(width / 2);
}

} // namespace

double checker(const TexturePlace& place) {
    const Vec3 widths = place.widths();
    double product = 1; // of +1 in even and -1 in odd layers
    for (int axis = 0; axis < 3; ++axis)
        product *= 2 * pulses(place.at[axis] / 2, widths[axis] / 2, 0, 0.5) - 1;
    return (1 - product) / 2;
}

double grid_lines(const TexturePlace& place, double line, bool space) {
    const Vec3 widths = place.widths();
    double between = 1;
    for (int axis = 0; axis < (space ? 3 : 2); ++axis)
        between *= pulses(place.at[axis], widths[axis], line / 2, 1 - line / 2);
    return 1 - between;
}

BrickPlace brick_at(const Vec3& place, const BrickBond& bond) {
    BrickPlace at{};
    at.row = std::floor(place.y / bond.height);
    const bool odd = std::fmod(std::abs(at.row), 2) == 1;
    const double x = place.x + (odd ? bond.width / 2 : 0);
    at.column = std::floor(x / bond.width);
    at.x = x - at.column * bond.width, at.y = place.y - at.row * bond.height;
    return at;
}

double bricks(const TexturePlace& place, const BrickBond& bond) {
    const BrickPlace at = brick_at(place.at, bond);
    const Vec3 widths = place.widths();
    const auto along = [&](double x, double width, double size) {
        const double half = bond.mortar / 2 / size;
        return pulses(x / size, width / size, half, 1 - half);
    };
    return along(at.x, widths.x, bond.width) * along(at.y, widths.y, bond.height);
}

double wood_radius(const Vec3& place, double distortion, std::uint32_t seed) {
    return std::hypot(place.x, place.y) + distortion * lattice_noise(place, seed);
}

double wood(const TexturePlace& place, double distortion, std::uint32_t seed) {
    const double rings = wood_radius(place.at, distortion, seed);
    const double share = sine_share(place.footprint());
    return 0.5 - 0.5 * share * std::cos(2 * std::numbers::pi * (rings - std::floor(rings)));
}

double marble(const TexturePlace& place, double distortion, const NoiseOctaves& octaves) {
    const double width = place.footprint();
    const double veins = distortion * turbulence(place.at, octaves, width);
    return 0.5 + 0.5 * sine_share(width) * std::sin(2 * std::numbers::pi * place.at.x + veins);
}

} // namespace keiko
