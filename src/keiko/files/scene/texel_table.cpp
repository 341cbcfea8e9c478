#include "keiko/files/scene/texel_table.h"

#include "keiko/files/toml/toml_reader.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <string>

namespace keiko {
namespace {

constexpr TomlLimits sizes{.low = 0.01, .high = 1e4}; ///< mm
constexpr TomlLimits angles{.low = -180, .high = 180};

/// Reads the number at a key into one that keeps its value where the key is absent.
void take(const TomlTable& table, std::string_view key, const TomlLimits& limits, double& number) {
    number = table.number(key, limits).value_or(number);
}

void take_curl(const TomlTable& table, FurSpec& fur) {
    const auto curl = table.table("curl");
    if (!curl) return;
    fur.curl_radius = curl->required("radius", curl->number("radius", sizes));
    fur.curl_turns = curl->required("turns", curl->number("turns", {.low = 0, .high = 100}));
    curl->finish();
}

FurSpec fur_from(const TomlTable& table, double thickness) {
    FurSpec fur;
    fur.length = thickness;
    take(table, "hairs", {.low = 0.001, .high = 1e5}, fur.hairs);
    take(table, "length", sizes, fur.length);
    take(table, "variation", TomlLimits::share(), fur.variation);
    take(table, "width", {.low = 0.001, .high = 100}, fur.width);
    take(table, "lean", {.low = 0, .high = 89}, fur.lean);
    take(table, "droop", {.low = 0, .high = 180}, fur.droop);
    take(table, "toward", angles, fur.toward);
    take(table, "disorder", {.low = 0, .high = 180}, fur.disorder);
    take_curl(table, fur);
    take(table, "block", sizes, fur.block);
    constexpr double most = 1e5; // in a block, so that it is laid within seconds
    const double laid = fur.hairs * fur.block * fur.block / 100;
    if (laid > most)
        throw table.error("hairs", "are " + std::to_string(std::llround(laid)) +
                                       " in a block of which it may have 100000");
    if (laid < 1)
        throw table.error(table.has("block") ? "block" : "hairs",
                          "a block has less than one hair: make it larger");
    return fur;
}

ClothSpec cloth_from(const TomlTable& table) {
    ClothSpec cloth;
    cloth.weave =
        static_cast<Weave>(table.choice("weave", {"plain", "twill", "satin"}).value_or(0));
    take(table, "spacing", sizes, cloth.spacing);
    take(table, "extinction", {.low = 0.001, .high = 1e4}, cloth.extinction);
    return cloth;
}

void take_voxels(const TomlTable& table, int& voxels) {
    voxels = table.integer("voxels", 8, 128).value_or(voxels);
    if (!std::has_single_bit(static_cast<unsigned>(voxels)))
        throw table.error("voxels", "must be a power of two: 8, 16, 32, 64 or 128");
}

/// Throws Error if hairs pass more voxels than they are laid in within seconds.
void require_few_voxels(const TomlTable& table, const TexelSpec& texels, const FurSpec& fur) {
    constexpr double most = 1e7;
    const double length = fur.length + 2 * std::numbers::pi * fur.curl_radius * fur.curl_turns;
    const double voxel = std::min(fur.block / texels.voxels, texels.thickness / 2);
    if (fur.hairs * fur.block * fur.block / 100 * length / voxel > most)
        throw table.error("hairs",
                          "pass more than 10000000 voxels of a block: take fewer, shorter or "
                          "less curled ones");
}

/// Throws Error at keys of the other kind of fibres.
void require_none_of(const TomlTable& table, std::initializer_list<std::string_view> keys,
                     const std::string& kind) {
    for (const std::string_view key : keys)
        if (table.has(key)) throw table.error(key, "belongs to kind = \"" + kind + "\"");
}

} // namespace

TexelSpec texels_from(const TomlTable& table) {
    TexelSpec texels;
    const auto kind = table.required("kind", table.choice("kind", {"fur", "cloth"}));
    texels.thickness = table.required("thickness", table.number("thickness", sizes));
    if (kind == 0) {
        require_none_of(table, {"weave", "spacing", "extinction"}, "cloth");
        texels.fibres = fur_from(table, texels.thickness);
    } else {
        require_none_of(table,
                        {"hairs", "length", "variation", "width", "lean", "droop", "toward",
                         "disorder", "curl", "block", "seed"},
                        "fur");
        texels.fibres = cloth_from(table);
    }
    take_voxels(table, texels.voxels);
    if (const auto* fur = std::get_if<FurSpec>(&texels.fibres))
        require_few_voxels(table, texels, *fur);
    if (const auto seed = table.integer("seed", 0, 1 << 30))
        texels.seed = static_cast<std::uint32_t>(*seed);
    texels.diffuse = table.rgb("diffuse", TomlLimits::share()).value_or(texels.diffuse);
    texels.specular = table.rgb("specular", TomlLimits::share()).value_or(texels.specular);
    const Rgb most = texels.diffuse + texels.specular;
    if (std::max({most.r, most.g, most.b}) > 1)
        throw table.error("specular",
                          "reflects with diffuse more light than arrives: their sum "
                          "is above 1");
    take(table, "exponent", {.low = 1, .high = 1e4}, texels.exponent);
    table.finish();
    return texels;
}

} // namespace keiko
