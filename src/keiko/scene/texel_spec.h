#pragma once

#include "keiko/base/export.h"
#include "keiko/math/rgb.h"

#include <cstdint>
#include <variant>

namespace KEIKO_API keiko {

/// Hairs that grow out of a surface. Lengths are mm of the scene.
struct FurSpec {
    double hairs = 100;     ///< on a square centimetre
    double length = 20;     ///< mm along a hair
    double variation = 0.2; ///< share, 0 to 1, by which hairs may be shorter
    double width = 0.1;     ///< mm
    double lean = 20;       ///< degrees from the normal at the root, below 90
    double droop = 30;      ///< degrees by which a hair bends over from there to its end
    double toward = 0;      ///< degrees from u to v: azimuth of the lean
    double disorder = 30;   ///< degrees by which the azimuth of a hair may differ, either way
    double curl_radius = 0; ///< mm, of the helix about the middle of a hair
    double curl_turns = 0;  ///< of that helix
    double block = 20;      ///< mm, side of the block that repeats

    bool operator==(const FurSpec&) const = default;
};

/// How threads of a cloth cross.
enum class Weave {
    plain, ///< over one, under one
    twill, ///< over two, under two, shifted by one from thread to thread
    satin  ///< over four, under one
};

/// Warp along u and weft along v.
struct ClothSpec {
    Weave weave = Weave::plain; ///< how they cross
    double spacing = 2;         ///< mm between the middles of threads
    double extinction = 10;     ///< 1/mm within a thread

    bool operator==(const ClothSpec&) const = default;
};

/// Texels: voxels of fibres in a shell over a surface (docs/theory/texels.md).
struct TexelSpec {
    std::variant<FurSpec, ClothSpec> fibres{}; ///< what the repeated block is filled with
    double thickness = 20;                     ///< mm of the shell, along the outward normal
    int voxels = 64;        ///< along a side of the block: a power of two from 8 to 128
    std::uint32_t seed = 1; ///< of random numbers
    Rgb diffuse{0.5};       ///< share of the light that fibres reflect to all sides
    Rgb specular{0.1};      ///< share that they reflect into the cone of the mirror direction
    double exponent = 20;   ///< of that highlight

    bool operator==(const TexelSpec&) const = default;
};

} // namespace keiko
