#include "fixtures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace keiko::fixtures {
namespace {

// The bored block of bored_block.cpp, in mm.
constexpr double length = 60, width = 40, height = 24, fillet = 5, bore = 6;
constexpr double block_volume = 52392.0055; // mm3, of its finished surfaces

constexpr double spacing = 0.75; // mm between nodes
constexpr std::array<int, 3> nodes{85, 57, 37};
constexpr std::array<double, 3> first{-31.5, -21, -1.5}; // mm

/// A pore: a ball without metal.
struct Pore {
    double x, y, z, radius;
};
constexpr std::array<Pore, 6> pores{{{18, 8, 12, 2.5},
                                     {-20, -9, 14, 1.8},
                                     {-17, 10, 8, 1.4},
                                     {12, -12, 16, 1.6},
                                     {23, -6, 8, 1.2},
                                     {-10, -13, 12, 2}}};

/// Distance to the surface of the casting with its pores, negative in the metal.
double distance(double x, double y, double z) {
    const std::array<double, 3> beyond{std::abs(x) - (length / 2 - fillet),
                                       std::abs(y) - (width / 2 - fillet),
                                       std::abs(z - height / 2) - (height / 2 - fillet)};
    double squares = 0;
    for (const double b : beyond) squares += std::max(b, 0.0) * std::max(b, 0.0);
    const double inside = std::min(0.0, *std::max_element(beyond.begin(), beyond.end()));
    double found = std::max(std::sqrt(squares) + inside - fillet, bore - std::hypot(x, y));
    for (const Pore& pore : pores)
        found = std::max(found, pore.radius - std::hypot(x - pore.x, y - pore.y, z - pore.z));
    return found;
}

/// Share of metal about a node: a blurred edge, as wide as two steps.
double metal(double x, double y, double z) {
    return std::clamp(0.5 - distance(x, y, z) / (2 * spacing), 0.0, 1.0);
}

/// Noise of a node between -1 and 1, by the mixing function of SplitMix64.
double noise(std::uint64_t node) {
    std::uint64_t mixed = (node + 1) * 0x9e3779b97f4a7c15U;
    mixed = (mixed ^ mixed >> 30U) * 0xbf58476d1ce4e5b9U;
    mixed = (mixed ^ mixed >> 27U) * 0x94d049bb133111ebU;
    return 2 * static_cast<double>((mixed ^ mixed >> 31U) >> 11U) * 0x1p-53 - 1;
}

double pore_volume() {
    double volume = 0;
    for (const Pore& pore : pores) volume += 4.0 / 3 * std::numbers::pi * std::pow(pore.radius, 3);
    return volume;
}

} // namespace

RawFixture casting() {
    constexpr double air = 20, solid = 200, amplitude = 12; // levels of 255
    RawFixture fixture{"casting.raw", {}, {}};
    double volume = 0;
    for (int k = 0; k < nodes[2]; ++k)
        for (int j = 0; j < nodes[1]; ++j)
            for (int i = 0; i < nodes[0]; ++i) {
                const double share =
                    metal(first[0] + i * spacing, first[1] + j * spacing, first[2] + k * spacing);
                volume += share * spacing * spacing * spacing;
                const double level =
                    air + (solid - air) * share + amplitude * noise(fixture.bytes.size());
                fixture.bytes.push_back(static_cast<char>(std::lround(level)));
            }
    const double promised = block_volume - pore_volume();
    fixture.truths = {{"nodes", "", 85 * 57 * 37, static_cast<double>(fixture.bytes.size()), 0},
                      {"volume", "mm^3", promised, volume, 2e-3 * promised}};
    return fixture;
}

} // namespace keiko::fixtures
