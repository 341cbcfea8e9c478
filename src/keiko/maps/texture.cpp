#include "keiko/maps/texture.h"

#include "keiko/maps/patterns.h"
#include "keiko/maps/reaction_diffusion.h"
#include "keiko/maps/voronoi.h"

#include <cassert>

namespace keiko {
namespace {

NoiseOctaves octaves_of(const TextureSpec& spec) {
    return {spec.seed, spec.octaves, spec.gain, spec.lacunarity};
}

std::optional<PictureTexture> picture_of(const TextureSpec& spec) {
    if (spec.kind == TextureKind::picture)
        return PictureTexture(read_linear_image(spec.file, spec.srgb));
    if (spec.kind == TextureKind::reaction_diffusion)
        return PictureTexture(reaction_diffusion(spec.feed, spec.kill, spec.seed));
    return {};
}

/// Derivatives along two directions.
struct Slopes2 {
    std::array<double, 2> first;
    double aa, ab, bb;
};

HeightJet in_world(double value, const Slopes2& slopes, const std::array<Vec3, 2>& gradient) {
    const auto& [a, b] = gradient;
    HeightJet jet;
    jet.value = value;
    jet.gradient = a * slopes.first[0] + b * slopes.first[1];
    for (int i = 0; i < 3; ++i)
        jet.second[static_cast<std::size_t>(i)] =
            a * (slopes.aa * a[i] + slopes.ab * b[i]) + b * (slopes.ab * a[i] + slopes.bb * b[i]);
    return jet;
}

} // namespace

Texture::Texture(const TextureSpec& spec, bool space)
    : spec_(spec), space_(space), picture_(picture_of(spec)) {
    if (spec.kind == TextureKind::orange_peel) peel_.emplace(spec.bands, spec.seed);
}

Rgb Texture::value(const TexturePlace& place) const {
    assert(!peel_);
    return picture_ ? picture_->value(place) : Rgb(procedure(place));
}

double Texture::grey(const TexturePlace& place) const {
    return picture_ ? luminance(picture_->value(place)) : procedure(place);
}

double Texture::procedure(const TexturePlace& place) const {
    const NoiseOctaves octaves = octaves_of(spec_);
    const double footprint = place.footprint();
    switch (spec_.kind) {
        case TextureKind::checker:
            return checker(place);
        case TextureKind::grid:
            return grid_lines(place, spec_.line, space_);
        case TextureKind::brick:
            return bricks(place, {spec_.brick.x, spec_.brick.y, spec_.brick.z});
        case TextureKind::noise:
            return 0.5 + 0.5 * octave_share(footprint) * lattice_noise(place.at, spec_.seed);
        case TextureKind::fractal:
            return 0.5 + 0.5 * fractal_noise(place.at, octaves, footprint) / octaves.total();
        case TextureKind::turbulence:
            return turbulence(place.at, octaves, footprint) / octaves.total();
        case TextureKind::wood:
            return wood(place, spec_.distortion, spec_.seed);
        case TextureKind::marble:
            return marble(place, spec_.distortion, octaves);
        case TextureKind::voronoi:
            return voronoi(place, spec_.voronoi, spec_.seed);
        case TextureKind::picture:
        case TextureKind::reaction_diffusion:
        case TextureKind::orange_peel:
            break;
    }
    assert(!"pictures and orange peel are no procedures");
    return 0;
}

HeightJet Texture::height(const TextureFrame& frame) const {
    const TexturePlace& place = frame.place;
    const std::array<Vec3, 2>&along = frame.along, &gradient = frame.gradient;
    if (peel_) {
        const HeightJet jet = peel_->height(place);
        return in_world(jet.value,
                        {{jet.gradient.dot(along[0]), jet.gradient.dot(along[1])},
                         jet.along(along[0], along[0]),
                         jet.along(along[0], along[1]),
                         jet.along(along[1], along[1])},
                        gradient);
    }
    constexpr double finest = 1e-3;
    const Vec2 texel = picture_ ? picture_->texel() : Vec2(finest);
    const auto step = [&](std::size_t i, double least) {
        const double size = along[i].length();
        const double pixel =
            std::max(std::abs(along[i].dot(place.dx)), std::abs(along[i].dot(place.dy)));
        return std::max(pixel / 2 / (size * size), least / size);
    };
    const double da = step(0, texel.x), db = step(1, texel.y);
    const auto at = [&](int a, int b) {
        return grey(place.moved(along[0] * (a * da) + along[1] * (b * db)));
    };
    const double middle = at(0, 0), left = at(-1, 0), right = at(1, 0), up = at(0, -1),
                 down = at(0, 1);
    return in_world(middle,
                    {{(right - left) / (2 * da), (down - up) / (2 * db)},
                     (right - 2 * middle + left) / (da * da),
                     (at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1)) / (4 * da * db),
                     (down - 2 * middle + up) / (db * db)},
                    gradient);
}

} // namespace keiko
