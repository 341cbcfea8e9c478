#include "keiko/maps/picture_texture.h"

#include "keiko/base/error.h"
#include "keiko/film/image_file.h"
#include "keiko/film/tone_mapping.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace keiko {
namespace {

/// Three channels of an image.
Image colors_of(const Image& image) {
    Image colors(image.width, image.height, 3);
    const int second = image.channels >= 3 ? 1 : 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const float* from = image.pixel(x, y);
            float* to = colors.pixel(x, y);
            to[0] = from[0], to[1] = from[second], to[2] = from[2 * second];
        }
    return colors;
}

/// Half as many columns, or rows for `down`: means over equal pieces of the image.
Image halved(const Image& image, bool down) {
    const int size = down ? image.height : image.width, less = (size + 1) / 2;
    Image half(down ? image.width : less, down ? less : image.height, image.channels);
    const double step = static_cast<double>(size) / less;
    const auto add = [&](int from, int to, double share) {
        for (int across = 0; across < (down ? image.width : image.height); ++across) {
            const float* a = down ? image.pixel(across, from) : image.pixel(from, across);
            float* b = down ? half.pixel(across, to) : half.pixel(to, across);
            for (int c = 0; c < image.channels; ++c) b[c] += static_cast<float>(share) * a[c];
        }
    };
    for (int to = 0; to < less; ++to) {
        const double begin = to * step, end = begin + step;
        for (int from = static_cast<int>(begin); from < size && from < end; ++from)
            add(from, to, (std::min(from + 1.0, end) - std::max<double>(from, begin)) / step);
    }
    return half;
}

int placed(int index, int size, Wrap border) {
    if (border == Wrap::clamp) return std::clamp(index, 0, size - 1);
    const int rest = index % size;
    return rest < 0 ? rest + size : rest;
}

Rgb color_at(const Image& image, int x, int y) {
    const float* pixel = image.pixel(x, y);
    return {static_cast<double>(pixel[0]), static_cast<double>(pixel[1]),
            static_cast<double>(pixel[2])};
}

/// A coordinate within the picture, so that it fits whole numbers.
double folded(double coordinate, Wrap border) {
    return border == Wrap::clamp ? std::clamp(coordinate, 0.0, 1.0)
                                 : coordinate - std::floor(coordinate);
}

} // namespace

PictureTexture::PictureTexture(const Image& image, Wrap along_u, Wrap along_v)
    : along_u_(along_u), along_v_(along_v) {
    levels_.push_back(colors_of(image));
    while (levels_.back().width > 1 || levels_.back().height > 1)
        levels_.push_back(halved(halved(levels_.back(), false), true));
}

Vec2 PictureTexture::texel() const {
    return {1.0 / width(), 1.0 / height()};
}

Rgb PictureTexture::texel_at(int column, int row) const {
    return color_at(levels_.front(), column, row);
}

Rgb PictureTexture::bilinear(const Image& level, double u, double v) const {
    const double x = folded(u, along_u_) * level.width - 0.5;
    const double y = folded(v, along_v_) * level.height - 0.5;
    const double x0 = std::floor(x), y0 = std::floor(y), fx = x - x0, fy = y - y0;
    const auto column = [&](int i) {
        return placed(static_cast<int>(x0) + i, level.width, along_u_);
    };
    const auto row = [&](int i) {
        return placed(static_cast<int>(y0) + i, level.height, along_v_);
    };
    const auto blend = [&](int i) {
        return color_at(level, column(0), row(i)) * (1 - fx) +
               color_at(level, column(1), row(i)) * fx;
    };
    return blend(0) * (1 - fy) + blend(1) * fy;
}

Rgb PictureTexture::at_level(double level, double u, double v) const {
    const double last = static_cast<double>(levels_.size() - 1);
    const double at = std::clamp(level, 0.0, last);
    const auto below = static_cast<std::size_t>(at);
    const double share = at - static_cast<double>(below);
    const Rgb fine = bilinear(levels_[below], u, v);
    return share > 0 ? fine * (1 - share) + bilinear(levels_[below + 1], u, v) * share : fine;
}

Rgb PictureTexture::value(const TexturePlace& place, int most) const {
    const auto texels = [&](const Vec3& step) {
        return std::hypot(step.x * width(), step.y * height());
    };
    const double x = texels(place.dx), y = texels(place.dy);
    const Vec3& longer = x > y ? place.dx : place.dy;
    const double wide = std::max(x, y);
    if (!(wide > 1)) return at_level(0, place.at.x, place.at.y);
    const double narrow = std::max({std::min(x, y), wide / most, 1.0});
    const int count = std::clamp(static_cast<int>(std::ceil(wide / narrow)), 1, most);
    Rgb sum;
    for (int i = 0; i < count; ++i) {
        const Vec3 at = place.at + longer * ((i + 0.5) / count - 0.5);
        sum += at_level(std::log2(narrow), at.x, at.y);
    }
    return sum / count;
}

Image read_linear_image(const std::filesystem::path& path, bool srgb) {
    Image image = read_image(path).image;
    if (image.width < 1 || image.height < 1 || image.channels < 1)
        throw Error(path.string(), "", "the picture is empty");
    for (float& value : image.values) {
        if (!std::isfinite(value)) throw Error(path.string(), "", "a pixel is not a finite number");
        if (srgb) value = static_cast<float>(srgb_eotf(static_cast<double>(value)));
    }
    return image;
}

} // namespace keiko
