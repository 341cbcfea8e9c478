#pragma once

#include "keiko/film/film.h"
#include "keiko/maps/texture_place.h"
#include "keiko/math/rgb.h"

#include <filesystem>
#include <vector>

namespace keiko {

/// How a picture goes on beyond its borders.
enum class Wrap {
    repeat, ///< periodically
    clamp   ///< by its last texels
};

/// A picture over [0, 1]^2 with its smaller versions: u along its rows, v down its columns, texel
/// centres at half integers. One channel is grey; of more than three the first three count.
class PictureTexture {
public:
    /// Texture of an image with a pixel at least.
    explicit PictureTexture(const Image& image, Wrap along_u = Wrap::repeat,
                            Wrap along_v = Wrap::repeat);

    /// Mean over the pixel around a place, whose x and y count: of up to `most` lookups along
    /// the longer side of the pixel in versions that suit the shorter [Heckbert1989]. Without width
    /// it is the bilinear value. `most` is at least 1; with fewer the shorter side is blurred.
    Rgb value(const TexturePlace& place, int most = 8) const;
    /// Width and height of a texel.
    Vec2 texel() const;
    /// Number of columns and rows.
    int width() const { return levels_.front().width; }
    int height() const { return levels_.front().height; } ///< rows
    /// The texel of a column and a row of the picture.
    Rgb texel_at(int column, int row) const;

private:
    Rgb bilinear(const Image& level, double u, double v) const;
    Rgb at_level(double level, double u, double v) const;

    std::vector<Image> levels_; ///< three channels, the whole picture first, a single texel last
    Wrap along_u_, along_v_;
};

/// Picture of a file in linear light; `srgb`: its values are decoded from sRGB. Throws Error.
Image read_linear_image(const std::filesystem::path& path, bool srgb);

} // namespace keiko
