#pragma once

#include "keiko/base/export.h"
#include "keiko/math/affine.h"
#include "keiko/math/rgb.h"
#include "keiko/math/vec.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace KEIKO_API keiko {

/// How places of a surface become texture coordinates (docs/theory/maps.md#projections).
enum class ProjectionKind {
    solid,       ///< the place itself, for textures of space
    planar,      ///< along the normal of a plane
    cylindrical, ///< about an axis, with the height along it
    spherical,   ///< about an axis, with the angle to it
    parameter    ///< the parameters of the face, 0 to 1 over its patches
};

/// A projection. Lengths are mm of the model, before its transform.
struct MapProjection {
    ProjectionKind kind = ProjectionKind::solid; ///< how places are projected
    Vec3 origin{0};                              ///< of the tile, or a point of the axis
    Vec3 u{1000, 0, 0};       ///< planar: edge of a tile; else direction of u = 0, across the axis
    Vec3 v{0, 1000, 0};       ///< planar: the other edge; the part along `u` is dropped
    Vec3 axis{0, 0, 1};       ///< of cylinder and sphere, of any length but 0
    double height = 1000;     ///< mm along the axis of a cylinder for v from 0 to 1
    Vec2 scale{1}, offset{0}; ///< u becomes scale u + offset

    bool operator==(const MapProjection&) const = default;
};

/// Quantity of a material that a map changes.
enum class MappedQuantity {
    diffuse,      ///< reflectance of the base
    roughness,    ///< width of the border's lobe
    gloss,        ///< share of what the border mirrors that is kept
    transmission, ///< share of what passes glass that is kept
    bump,         ///< height of the surface
    normal,       ///< normal of the surface, from a picture
    emission      ///< luminance that the material emits
};

/// Kinds of textures.
enum class TextureKind {
    picture,            ///< of a file
    checker,            ///< cubes, alternately 0 and 1
    grid,               ///< lines of 1 around cubes of 0
    brick,              ///< bricks of 1, mortar of 0
    noise,              ///< lattice noise
    fractal,            ///< 1/f noise: octaves of lattice noise
    turbulence,         ///< octaves of the absolute value of lattice noise
    wood,               ///< rings about z
    marble,             ///< veins across x
    voronoi,            ///< cells about scattered points
    reaction_diffusion, ///< spots and stripes of two reacting substances
    orange_peel         ///< waves of a paint's surface by bands of wavelength
};

/// Part of a Voronoi diagram that a texture shows.
enum class VoronoiValue {
    distance, ///< to the nearest point, in cells
    ridge,    ///< how much farther the next but one is, in cells: 0 on the borders of cells
    cell      ///< a random number of the cell
};

/// A texture: values from 0 to 1, or a picture's colours, over texture coordinates.
struct TextureSpec {
    TextureKind kind = TextureKind::noise; ///< of the values below those of other kinds are unread
    std::filesystem::path file{};          ///< of a picture
    bool srgb = false;                     ///< whether the picture's values are decoded from sRGB
    double size = 100;                     ///< mm of the model, or of coordinates: of a cell
    std::uint32_t seed = 1;                ///< of random numbers
    int octaves = 5;                       ///< of noise
    double gain = 0.5, lacunarity = 2;     ///< factors of amplitude and frequency, by octave
    double distortion = 1;                 ///< of wood and marble by noise
    double line = 0.05;                    ///< width of lines, cells
    Vec3 brick{1, 0.5, 0.05};              ///< width and height of a brick, and of the mortar
    VoronoiValue voronoi = VoronoiValue::ridge; ///< what it shows
    double feed = 0.037, kill = 0.06;           ///< rates of reaction and diffusion
    std::array<double, 5> bands{}; ///< orange peel: rms height in um of Wa, Wb, Wc, Wd, We

    bool operator==(const TextureSpec&) const = default;
};

/// Region where a map counts: inside of a polygon of texture coordinates.
struct MapRegion {
    MapProjection projection{}; ///< gives the coordinates, before scale and offset wrap
    std::vector<Vec2> corners;  ///< in order; concave or not

    bool operator==(const MapRegion&) const = default;
};

/// A map on a material. Several of a kind multiply; heights add up.
struct MaterialMap {
    MappedQuantity drives = MappedQuantity::diffuse; ///< what it changes
    TextureSpec texture{};                           ///< its values
    MapProjection projection{};                      ///< where they lie
    Rgb low{0}, high{1};               ///< what values 0 and 1 stand for; heights are grey, mm
    double factor = 1;                 ///< 0 to 1: how much of the map counts
    std::optional<MapRegion> region{}; ///< everywhere if empty
    Affine placement{};                ///< of the model in the scene

    bool operator==(const MaterialMap&) const = default;
};

} // namespace keiko
