#include "keiko/files/scene/map_table.h"

#include "keiko/files/scene/rig_tables.h"
#include "keiko/files/scene/texture_table.h"
#include "keiko/files/toml/toml_reader.h"

namespace keiko {
namespace {

constexpr TomlLimits factors{.low = 0, .high = 1000};

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
    if (solid && is_two_dimensional(map.texture.kind))
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
    if (is_two_dimensional(map.texture.kind)) map.projection.kind = ProjectionKind::parameter;
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
