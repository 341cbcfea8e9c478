#pragma once

#include "keiko/math/vec.h"

#include <cstdint>

namespace keiko {

/// Random 32 bits of a point of the lattice of whole numbers, the same on every machine.
std::uint32_t lattice_hash(std::int32_t i, std::int32_t j, std::int32_t k, std::uint32_t seed);

/// The whole number below a coordinate, as an index of the lattice. Those beyond 2e9 are taken for
/// it: there doubles tell no places of a cell apart.
std::int32_t lattice_cell(double coordinate);

/// Lattice noise of a place, -1 to 1: random values at the lattice's points, between them by
/// quintic blends, so that its second derivatives are continuous [Perlin2002].
double lattice_noise(const Vec3& place, std::uint32_t seed);

/// Octaves of noise.
struct NoiseOctaves {
    std::uint32_t seed = 1;            ///< the same of all
    int count = 5;                     ///< 1 or more
    double gain = 0.5, lacunarity = 2; ///< factors of amplitude and frequency of the next

    /// Sum of all amplitudes.
    double total() const;
};

/// Sum of octaves. Those whose cells are less than two `footprint`s wide fade out [Norton1982], so
/// that no octave is sampled too coarsely.
double fractal_noise(const Vec3& place, const NoiseOctaves& octaves, double footprint);
/// Sum of octaves of the absolute value of noise; they fade to its mean.
double turbulence(const Vec3& place, const NoiseOctaves& octaves, double footprint);

/// Share of a texture whose cells have the size 1 that a footprint leaves: 1 up to half a cell, 0
/// from a cell on.
double octave_share(double footprint);

} // namespace keiko
