#include "keiko/files/scene/rig_tables.h"
#include "keiko/files/toml/toml_reader.h"
#include "keiko/files/toml/toml_text.h"
#include "keiko/light/luminance/photometry.h"
#include "keiko/math/bounds.h"
#include "keiko/math/polygon.h"

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

/// Share of a polygon's size by which its corners may miss a plane.
constexpr double flat_enough = 1e-6;
/// Limit that keeps the test of all sides against each other short.
constexpr std::size_t most_corners = 1000;

/// True if two sides of a polygon with this normal cross inside of both.
bool cross(const Segment& p, const Segment& q, const Vec3& normal) {
    const auto side = [&](const Segment& line, const Vec3& at) {
        return normal.dot((line.b - line.a).cross(at - line.a));
    };
    return side(p, q.a) * side(p, q.b) < 0 && side(q, p.a) * side(q, p.b) < 0;
}

bool sides_cross(const std::vector<Vec3>& corners, const Vec3& normal) {
    const std::size_t count = corners.size();
    const auto side = [&](std::size_t i) { return Segment{corners[i], corners[(i + 1) % count]}; };
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = i + 2; k < count; ++k)
            if (cross(side(i), side(k), normal)) return true;
    return false;
}

/// Luminance of a diffuse source of `area` mm2, by its own key or by its flux; `otherwise` if the
/// table has neither.
Rgb luminance_from(const TomlTable& table, double area, const Rgb& otherwise) {
    const auto luminance = table.rgb("luminance", TomlLimits::light());
    const auto flux = table.number("luminous_flux", TomlLimits::light());
    if (luminance && flux)
        throw table.error("luminous_flux", "give either luminance or luminous_flux, not both");
    const Rgb own = flux ? Rgb(diffuse_luminance(*flux, area)) : luminance.value_or(otherwise);
    const Rgb colored = own * color_of(table);
    require_light(table, flux ? "luminous_flux" : "luminance", colored);
    return colored;
}

} // namespace

std::vector<Vec3> corners_from(const TomlTable& table) {
    std::vector<Vec3> corners;
    for (const auto& corner :
         table.required("corners", table.lists("corners", TomlLimits::place()))) {
        if (corner.size() != 3) throw table.error("corners", "must be arrays of 3 numbers");
        corners.emplace_back(corner[0], corner[1], corner[2]);
    }
    return corners;
}

void require_polygon(const TomlTable& table, const std::vector<Vec3>& corners) {
    if (corners.size() < 3) throw table.error("corners", "must be at least 3");
    Box3 box;
    for (const Vec3& corner : corners) box.extend(corner);
    const Vec3 normal = polygon_normal(corners);
    if (!(normal.length() > flat_enough * box.size() * box.size()))
        throw table.error("corners", "enclose no area");
    for (const Vec3& corner : corners)
        if (std::abs(normal.dot(corner - corners.front())) >
            flat_enough * box.size() * normal.length())
            throw table.error("corners", "must lie in a plane");
}

PolygonLight polygon_light_from(const TomlTable& table) {
    PolygonLight light;
    light.corners = corners_from(table);
    light.two_sided = table.flag("two_sided").value_or(light.two_sided);
    if (light.corners.size() > most_corners)
        throw table.error("corners", "must be at most " + std::to_string(most_corners));
    require_polygon(table, light.corners);
    const Vec3 normal = polygon_normal(light.corners);
    if (sides_cross(light.corners, normal)) throw table.error("corners", "sides cross each other");
    const double area = normal.length() / 2 * (light.two_sided ? 2 : 1);
    light.luminance = luminance_from(table, area, light.luminance);
    table.finish();
    return light;
}

std::string table_text(const PolygonLight& light) {
    std::string text = "\n[[polygon]]\n" + corners_line(light.corners);
    if (light.two_sided) text += toml_line("two_sided", "true");
    return text + toml_line("luminance", toml_value(light.luminance), "cd/m2");
}

std::string corners_line(const std::vector<Vec3>& corners) {
    std::string list;
    for (const Vec3& corner : corners) list += (list.empty() ? "" : ", ") + toml_value(corner);
    return toml_line("corners", "[" + list + "]", "mm");
}

SphereLight sphere_light_from(const TomlTable& table) {
    SphereLight light;
    light.center = table.required("center", table.vector("center"));
    light.radius = table.required("radius", table.number("radius", TomlLimits::length()));
    const double area = 4 * std::numbers::pi * light.radius * light.radius;
    light.luminance = luminance_from(table, area, light.luminance);
    table.finish();
    return light;
}

std::string table_text(const SphereLight& light) {
    std::string text = "\n[[sphere]]\n";
    text += toml_line("center", toml_value(light.center), "mm");
    text += toml_line("radius", toml_value(light.radius), "mm");
    return text + toml_line("luminance", toml_value(light.luminance), "cd/m2");
}

} // namespace keiko
