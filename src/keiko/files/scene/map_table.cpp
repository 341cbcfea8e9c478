#include "keiko/files/scene/map_table.h"

#include "keiko/base/text.h"
#include "keiko/files/scene/rig_tables.h"
#include "keiko/files/toml/toml_reader.h"

namespace keiko {
namespace {

constexpr int most_octaves = 16;
constexpr TomlLimits factors{.low = 0, .high = 1000};

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

/// True for textures of two coordinates, which fill no space.
bool is_flat(TextureKind kind) {
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
    else if (!is_flat(texture.kind))
        texture.size = table.number("size", TomlLimits::length()).value_or(texture.size);
    table.finish();
    return texture;
}

Vec3 direction_from(const TomlTable& table, std::string_view key, const Vec3& otherwise) {
    const Vec3 direction = table.vector(key).value_or(otherwise);
    if (!(direction.length() > 0)) throw table.error(key, "must not be a zero vector");
    return direction;
}

/// Throws Error at a key of a direction that is parallel to another.
void require_across(const TomlTable& table, std::string_view key, const Vec3& direction,
                    const Vec3& other, const std::string& name) {
    if (!(direction.cross(other).length() > 1e-6 * direction.length() * other.length()))
        throw table.error(key, "must not be parallel to " + name);
}

void take_axis(const TomlTable& table, MapProjection& projection) {
    projection.axis = direction_from(table, "axis", projection.axis);
    const bool along = std::abs(projection.axis.normalized().x) > 0.9;
    projection.u = direction_from(table, "u", along ? Vec3(0, 1, 0) : Vec3(1, 0, 0));
    require_across(table, "u", projection.u, projection.axis, "axis");
}

MapProjection projection_from(const TomlTable& table) {
    MapProjection projection;
    projection.kind = static_cast<ProjectionKind>(table.required(
        "kind",
        table.choice("kind", {"solid", "planar", "cylindrical", "spherical", "parameter"})));
    const bool about_axis = projection.kind == ProjectionKind::cylindrical ||
                            projection.kind == ProjectionKind::spherical;
    if (about_axis || projection.kind == ProjectionKind::planar)
        projection.origin = table.vector("origin").value_or(projection.origin);
    if (projection.kind == ProjectionKind::planar) {
        projection.u = direction_from(table, "u", projection.u);
        projection.v = direction_from(table, "v", projection.v);
        require_across(table, "v", projection.v, projection.u, "u");
    }
    if (about_axis) take_axis(table, projection);
    if (projection.kind == ProjectionKind::cylindrical)
        projection.height =
            table.number("height", TomlLimits::length()).value_or(projection.height);
    if (projection.kind != ProjectionKind::solid) {
        constexpr TomlLimits either{.low = -1e6, .high = 1e6};
        if (const auto scale = table.numbers("scale", 2, either))
            projection.scale = {(*scale)[0], (*scale)[1]};
        if (!(projection.scale.x != 0 && projection.scale.y != 0))
            throw table.error("scale", "must not be 0");
        if (const auto offset = table.numbers("offset", 2, either))
            projection.offset = {(*offset)[0], (*offset)[1]};
    }
    table.finish();
    return projection;
}

MapRegion region_from(const TomlTable& table) {
    MapRegion region;
    region.projection.kind = ProjectionKind::parameter;
    if (const auto projection = table.table("projection")) {
        region.projection = projection_from(*projection);
        if (region.projection.kind == ProjectionKind::solid)
            throw projection->error("kind", "a region needs a projection with two coordinates");
    }
    std::vector<Vec3> outline;
    for (const std::vector<double>& corner :
         table.required("corners", table.lists("corners", {.low = -1e9, .high = 1e9}))) {
        if (corner.size() != 2) throw table.error("corners", "must be arrays of 2 numbers");
        region.corners.emplace_back(corner[0], corner[1]);
        outline.emplace_back(corner[0], corner[1], 0);
    }
    require_ring(table, outline);
    table.finish();
    return region;
}

/// Throws Error at `drives` for what the material does not have.
void require_owner(const TomlTable& map, MappedQuantity drives, const Material& material) {
    const auto refuse_unless = [&](bool owns, const char* owner) {
        if (!owns) throw map.error("drives", std::string("needs ") + owner);
    };
    switch (drives) {
        case MappedQuantity::diffuse:
            return refuse_unless(!material.metal && !material.glass,
                                 "a paint, not a metal or glass");
        case MappedQuantity::roughness:
            return refuse_unless(material.roughness.has_value(), "a material with roughness");
        case MappedQuantity::gloss:
            return refuse_unless(material.metal || material.refractive_index > 1,
                                 "a border: a refractive_index above 1, or a metal");
        case MappedQuantity::transmission:
            return refuse_unless(material.glass.has_value(), "glass");
        case MappedQuantity::emission:
            return refuse_unless(material.emits != Rgb(0), "a material that emits");
        case MappedQuantity::bump:
        case MappedQuantity::normal:
            return;
    }
}

/// Quantities that the values 0 and 1 of a map stand for.
void take_range(const TomlTable& table, MaterialMap& map) {
    const bool peel = map.texture.kind == TextureKind::orange_peel;
    if (map.drives == MappedQuantity::normal) {
        map.low = Rgb(-1), map.high = Rgb(1);
        if (table.flag("flip_green").value_or(false)) map.low.g = 1, map.high.g = -1;
    } else if (map.drives == MappedQuantity::bump) {
        if (!peel)
            map.high =
                Rgb(table.required("height", table.number("height", {.low = -1000, .high = 1000})));
    } else {
        map.low = table.rgb("low", factors).value_or(map.low);
        map.high = table.rgb("high", factors).value_or(map.high);
    }
}

void require_texture(const TomlTable& table, const MaterialMap& map) {
    const bool peel = map.texture.kind == TextureKind::orange_peel;
    if (peel && map.drives != MappedQuantity::bump)
        throw table.error("texture", "orange-peel is a height: drives = \"bump\"");
    if (map.drives == MappedQuantity::normal && map.texture.kind != TextureKind::picture)
        throw table.error("texture", "a normal map is a picture");
    const bool solid = map.projection.kind == ProjectionKind::solid;
    if (solid && is_flat(map.texture.kind))
        throw table.error("projection", "a picture fills no space: it needs another kind");
    if (!solid && peel) throw table.error("projection", "orange-peel lies in space, in mm");
}

MappedQuantity quantity_from(const TomlTable& table, const Material& material) {
    const auto drives = static_cast<MappedQuantity>(table.required(
        "drives", table.choice("drives", {"diffuse", "roughness", "gloss", "transmission", "bump",
                                          "normal", "emission"})));
    require_owner(table, drives, material);
    return drives;
}

MaterialMap map_from(const TomlTable& table, MappedQuantity drives) {
    MaterialMap map;
    map.drives = drives;
    const auto texture = table.table("texture");
    if (!texture) table.refuse_missing("texture");
    map.texture = texture_from(*texture, map.drives);
    if (is_flat(map.texture.kind)) map.projection.kind = ProjectionKind::parameter;
    if (const auto projection = table.table("projection")) {
        map.projection = projection_from(*projection);
        if (map.projection.kind != ProjectionKind::solid && texture->has("size"))
            throw texture->error("size", "belongs to textures in space; a projection has a scale");
    }
    require_texture(table, map);
    take_range(table, map);
    map.factor = table.number("factor", TomlLimits::share()).value_or(map.factor);
    if (const auto region = table.table("region")) map.region = region_from(*region);
    table.finish();
    return map;
}

} // namespace

namespace {

/// The tables `map` of a table, each read by `read`.
template <class Read>
std::vector<MaterialMap> all_maps(const TomlTable& table, const Read& read) {
    constexpr std::size_t most = 64;
    std::vector<MaterialMap> maps;
    for (const TomlTable& map : table.tables("map")) maps.push_back(read(map));
    if (maps.size() > most) throw table.error("map", "more than 64 maps");
    return maps;
}

} // namespace

std::vector<MaterialMap> maps_from(const TomlTable& table, const Material& material) {
    return all_maps(
        table, [&](const TomlTable& map) { return map_from(map, quantity_from(map, material)); });
}

std::vector<MaterialMap> luminance_maps_from(const TomlTable& table) {
    return all_maps(table,
                    [](const TomlTable& map) { return map_from(map, MappedQuantity::emission); });
}

} // namespace keiko
