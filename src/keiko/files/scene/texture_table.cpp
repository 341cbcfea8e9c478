#include "keiko/files/scene/texture_table.h"

#include "keiko/base/text.h"
#include "keiko/files/toml/toml_reader.h"

#include <string>

namespace keiko {
namespace {

constexpr int most_octaves = 16;

std::uint32_t seed_from(const TomlTable& table, std::uint32_t otherwise) {
    constexpr int most = 2147483647;
    const auto seed = table.integer("seed", 0, most);
    return seed ? static_cast<std::uint32_t>(*seed) : otherwise;
}

void take_octaves(const TomlTable& table, TextureSpec& texture) {
    texture.octaves = table.integer("octaves", 1, most_octaves).value_or(texture.octaves);
    texture.gain = table.number("gain", TomlLimits::share()).value_or(texture.gain);
    texture.lacunarity =
        table.number("lacunarity", {.low = 1, .high = 8}).value_or(texture.lacunarity);
}

void take_distortion(const TomlTable& table, double otherwise, TextureSpec& texture) {
    texture.distortion = table.number("distortion", {.low = 0, .high = 100}).value_or(otherwise);
}

bool is_color(MappedQuantity quantity) {
    return quantity == MappedQuantity::diffuse || quantity == MappedQuantity::emission;
}

/// Pictures of reflectances and luminances are sRGB unless their format holds linear light.
void take_picture(const TomlTable& table, MappedQuantity drives, TextureSpec& texture) {
    texture.file = table.required("file", path_from(table, "file"));
    const std::string extension = lower_case(texture.file.extension().string());
    const bool linear = extension == ".exr" || extension == ".hdr";
    texture.srgb = table.flag("srgb").value_or(is_color(drives) && !linear);
}

void take_bricks(const TomlTable& table, TextureSpec& texture) {
    const auto size = table.numbers("brick", 2, {.low = 1e-3, .high = 1e3});
    if (size) texture.brick.x = (*size)[0], texture.brick.y = (*size)[1];
    texture.brick.z = table.number("mortar", TomlLimits::share()).value_or(texture.brick.z);
    if (!(texture.brick.z < texture.brick.x && texture.brick.z < texture.brick.y))
        throw table.error("mortar", "must be thinner than a brick is wide and high");
}

void take_bands(const TomlTable& table, TextureSpec& texture) {
    const auto bands = table.required(
        "bands", table.numbers("bands", texture.bands.size(), {.low = 0, .high = 1000}));
    for (std::size_t i = 0; i < texture.bands.size(); ++i) texture.bands[i] = bands[i];
}

void take_reaction(const TomlTable& table, TextureSpec& texture) {
    constexpr TomlLimits rates{.low = 0, .high = 0.2};
    texture.feed = table.number("feed", rates).value_or(texture.feed);
    texture.kill = table.number("kill", rates).value_or(texture.kill);
}

/// The keys of one kind of texture.
void take_kind(const TomlTable& table, MappedQuantity drives, TextureSpec& texture) {
    constexpr double wood_distortion = 0.3, marble_distortion = 6;
    switch (texture.kind) {
        case TextureKind::picture:
            return take_picture(table, drives, texture);
        case TextureKind::grid:
            texture.line = table.number("line", TomlLimits::share()).value_or(texture.line);
            return;
        case TextureKind::brick:
            return take_bricks(table, texture);
        case TextureKind::fractal:
        case TextureKind::turbulence:
            return take_octaves(table, texture);
        case TextureKind::wood:
            return take_distortion(table, wood_distortion, texture);
        case TextureKind::marble:
            take_octaves(table, texture);
            return take_distortion(table, marble_distortion, texture);
        case TextureKind::voronoi:
            if (const auto value = table.choice("value", {"distance", "ridge", "cell"}))
                texture.voronoi = static_cast<VoronoiValue>(*value);
            return;
        case TextureKind::reaction_diffusion:
            return take_reaction(table, texture);
        case TextureKind::orange_peel:
            return take_bands(table, texture);
        case TextureKind::checker:
        case TextureKind::noise:
            return;
    }
}

bool is_random(TextureKind kind) {
    return kind != TextureKind::picture && kind != TextureKind::checker &&
           kind != TextureKind::grid && kind != TextureKind::brick;
}

} // namespace

bool is_two_dimensional(TextureKind kind) {
    return kind == TextureKind::picture || kind == TextureKind::reaction_diffusion;
}

TextureSpec texture_from(const TomlTable& table, MappedQuantity drives) {
    TextureSpec texture;
    texture.kind = static_cast<TextureKind>(table.required(
        "kind", table.choice("kind", {"picture", "checker", "grid", "brick", "noise", "fractal",
                                      "turbulence", "wood", "marble", "voronoi",
                                      "reaction-diffusion", "orange-peel"})));
    take_kind(table, drives, texture);
    if (is_random(texture.kind)) texture.seed = seed_from(table, texture.seed);
    if (texture.kind == TextureKind::orange_peel)
        texture.size = 1;
    else if (!is_two_dimensional(texture.kind))
        texture.size = table.number("size", TomlLimits::length()).value_or(texture.size);
    table.finish();
    return texture;
}

} // namespace keiko
