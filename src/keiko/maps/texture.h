#pragma once

#include "keiko/maps/orange_peel.h"
#include "keiko/maps/picture_texture.h"
#include "keiko/maps/texture_place.h"
#include "keiko/math/rgb.h"
#include "keiko/scene/material_map.h"

#include <array>
#include <optional>

namespace keiko {

/// A place in texture coordinates and two directions of the surface there.
struct TextureFrame {
    TexturePlace place{};
    std::array<Vec3, 2> along{Vec3(0), Vec3(0)};    ///< the directions, in texture coordinates
    std::array<Vec3, 2> gradient{Vec3(0), Vec3(0)}; ///< of the place along each, world, 1/mm
};

/// A prepared texture: what its specification stands for at any place.
class Texture {
public:
    /// Reads the picture, or makes it. `space`: the texture lies in space, not on a projection.
    /// Throws Error.
    Texture(const TextureSpec& spec, bool space);

    /// Colour, or a grey from 0 to 1, in the mean over the pixel. Not of orange peel.
    Rgb value(const TexturePlace& place) const;
    /// Height with its derivatives in the world, per mm, where the value 1 is 1 mm high; of orange
    /// peel its own height. Differences over half a pixel, but at least over a texel or 1/1000 of a
    /// cell.
    HeightJet height(const TextureFrame& frame) const;

private:
    double grey(const TexturePlace& place) const;
    double procedure(const TexturePlace& place) const;

    TextureSpec spec_;
    bool space_;
    std::optional<PictureTexture> picture_;
    std::optional<OrangePeel> peel_;
};

} // namespace keiko
