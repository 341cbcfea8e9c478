#pragma once

#include "keiko/maps/lattice_noise.h"
#include "keiko/maps/texture_place.h"

namespace keiko {

/// Cubes of side 1, alternately 0 and 1, in the mean over the pixel's widths.
double checker(const TexturePlace& place);

/// Lines of 1 in the planes of whole coordinates, `line` wide, around cubes of 0, in the mean over
/// the pixel's widths. `space`: false for lines in x and y alone.
double grid_lines(const TexturePlace& place, double line, bool space);

/// A bond of bricks in x and y, and the mortar between them.
struct BrickBond {
    double width = 1, height = 0.5; ///< of a brick with its mortar
    double mortar = 0.05;           ///< thickness, below both
};
/// Column and row of the brick at a place: odd rows lie half a brick further to the left.
struct BrickPlace {
    double column, row; ///< whole numbers
    double x, y;        ///< from the lower left corner of the brick with its mortar
};
/// The brick at a place.
BrickPlace brick_at(const Vec3& place, const BrickBond& bond);
/// 1 on bricks and 0 on mortar, in the mean over the pixel's widths within the brick's row.
double bricks(const TexturePlace& place, const BrickBond& bond);

/// Rings about the z axis: 0 at their inner borders, 1 in their middles. `distortion`: by how much
/// noise moves them, in rings. Rings narrower than the pixel fade to their mean.
double wood(const TexturePlace& place, double distortion, std::uint32_t seed);
/// Radius of a place from the axis in rings, distorted by noise.
double wood_radius(const Vec3& place, double distortion, std::uint32_t seed);

/// Veins across x: a sine of x that turbulence distorts; 0 to 1. They fade as those of wood.
double marble(const TexturePlace& place, double distortion, const NoiseOctaves& octaves);

} // namespace keiko
