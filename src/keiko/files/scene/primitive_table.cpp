#include "keiko/files/scene/rig_tables.h"
#include "keiko/files/toml/toml_reader.h"
#include "keiko/files/toml/toml_text.h"
#include "keiko/light/luminance/photometry.h"
#include "keiko/light/rig/primitive_lights.h"

#include <cmath>
#include <utility>

namespace keiko {
namespace {

/// Share of a body with right angles, or of a square, below which it is flat.
constexpr double flat = 1e-6;
constexpr TomlLimits rim_radii{.low = 0, .high = TomlLimits::length().high};

Vec3 vector_of(const TomlTable& table, std::string_view key) {
    return table.required(key, table.vector(key));
}
double radius_of(const TomlTable& table) {
    return table.required("radius", table.number("radius", TomlLimits::length()));
}

/// Throws Error at `w` if three vectors lie in a plane.
void require_volume(const TomlTable& table, const Vec3& u, const Vec3& v, const Vec3& w) {
    if (!(std::abs(u.dot(v.cross(w))) > flat * u.length() * v.length() * w.length()))
        throw table.error("w", "u, v and w must not lie in a plane");
}

EllipsoidShape sphere_from(const TomlTable& table) {
    const Vec3 center = vector_of(table, "center");
    const double r = radius_of(table);
    return {center, Vec3(r, 0, 0), Vec3(0, r, 0), Vec3(0, 0, r)};
}

EllipsoidShape ellipsoid_from(const TomlTable& table) {
    EllipsoidShape shape;
    shape.center = vector_of(table, "center");
    shape.u = vector_of(table, "u");
    shape.v = vector_of(table, "v");
    shape.w = vector_of(table, "w");
    require_volume(table, shape.u, shape.v, shape.w);
    return shape;
}

FrustumShape frustum_from(const TomlTable& table, bool cone) {
    FrustumShape shape;
    shape.from = vector_of(table, "from");
    shape.to = vector_of(table, "to");
    if (!((shape.to - shape.from).length() >= TomlLimits::length().low))
        throw table.error("to", "must differ from 'from'");
    if (cone) {
        shape.radius = table.required("radius", table.number("radius", rim_radii));
        shape.to_radius = table.number("to_radius", rim_radii).value_or(shape.to_radius);
        if (!(shape.radius > 0 || shape.to_radius > 0))
            throw table.error("radius", "radius and to_radius must not both be 0");
    } else {
        shape.radius = shape.to_radius = radius_of(table);
    }
    shape.open = table.flag("open").value_or(shape.open);
    return shape;
}

/// A unit vector as it is, so that what is written reads back as the same.
Vec3 unit_of(const Vec3& direction) {
    constexpr double rounding = 4e-15;
    return std::abs(direction.length2() - 1) < rounding ? direction : direction.normalized();
}

DiscShape disc_from(const TomlTable& table) {
    const Vec3 normal = vector_of(table, "normal");
    if (!(normal.length() > 0)) throw table.error("normal", "must not be a zero vector");
    return {vector_of(table, "center"), unit_of(normal), radius_of(table)};
}

PlaneShape plane_from(const TomlTable& table) {
    PlaneShape shape{vector_of(table, "origin"), vector_of(table, "u"), vector_of(table, "v")};
    if (!(shape.u.cross(shape.v).length() > flat * shape.u.length() * shape.v.length()))
        throw table.error("v", "u and v must not be parallel");
    return shape;
}

BoxShape box_from(const TomlTable& table) {
    BoxShape shape{vector_of(table, "origin"), vector_of(table, "u"), vector_of(table, "v"),
                   vector_of(table, "w")};
    require_volume(table, shape.u, shape.v, shape.w);
    if (shape.u.dot(shape.v.cross(shape.w)) < 0) std::swap(shape.v, shape.w);
    return shape;
}

/// The lights of a shape by the keys of its luminance, which end the table.
std::vector<LightSource> lights_from(const TomlTable& table, const PrimitiveShape& shape) {
    const Rgb luminance = luminance_from(table, PolygonLight{}.luminance, [&](double flux) {
        return diffuse_luminance(flux, surface_area(shape));
    });
    table.finish();
    return lights_of(shape, luminance);
}

std::string table_begin(std::string_view kind) {
    return "\n[[primitive]]\n" + toml_line("kind", toml_string(kind));
}
std::string place_line(std::string_view key, const Vec3& place) {
    return toml_line(key, toml_value(place), "mm");
}
std::string luminance_line(const Rgb& luminance) {
    return toml_line("luminance", toml_value(luminance), "cd/m2");
}

} // namespace

PrimitiveShape primitive_shape_from(const TomlTable& table) {
    const auto kind =
        table.choice("kind", {"sphere", "ellipsoid", "cylinder", "cone", "disc", "plane", "box"});
    switch (table.required("kind", kind)) {
        case 0:
            return sphere_from(table);
        case 1:
            return ellipsoid_from(table);
        case 2:
            return frustum_from(table, false);
        case 3:
            return frustum_from(table, true);
        case 4:
            return disc_from(table);
        case 5:
            return plane_from(table);
        default:
            return box_from(table);
    }
}

std::vector<LightSource> primitive_lights_from(const TomlTable& table) {
    return lights_from(table, primitive_shape_from(table));
}

std::vector<LightSource> box_lights_from(const TomlTable& table) {
    return lights_from(table, box_from(table));
}

std::string table_text(const DiscLight& light) {
    return table_begin("disc") + place_line("center", light.center) +
           toml_line("normal", toml_value(light.normal)) +
           toml_line("radius", toml_value(light.radius), "mm") + luminance_line(light.luminance);
}

std::string table_text(const FrustumLight& light) {
    const bool cone = light.radius != light.to_radius;
    std::string text = table_begin(cone ? "cone" : "cylinder") + place_line("from", light.from) +
                       place_line("to", light.to) +
                       toml_line("radius", toml_value(light.radius), "mm");
    if (cone) text += toml_line("to_radius", toml_value(light.to_radius), "mm");
    return text + toml_line("open", "true") + luminance_line(light.luminance);
}

std::string table_text(const EllipsoidLight& light) {
    return table_begin("ellipsoid") + place_line("center", light.center) +
           place_line("u", light.u) + place_line("v", light.v) + place_line("w", light.w) +
           luminance_line(light.luminance);
}

} // namespace keiko
