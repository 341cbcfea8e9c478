#include "keiko/files/scene/rig_file.h"

#include "keiko/base/input_file.h"
#include "keiko/base/output_file.h"
#include "keiko/files/scene/rig_tables.h"
#include "keiko/files/toml/toml_reader.h"
#include "keiko/files/toml/toml_text.h"
#include "keiko/math/polygon.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace keiko {
namespace {

constexpr std::string_view format = "keiko-rig/1";
/// Sine of an angle to a window's plane below which the sun shines along it.
constexpr double along_plane = 1e-6;

Window window_from(const TomlTable& table, const Vec3& sun) {
    const Window window{corners_from(table)};
    table.finish();
    require_polygon(table, window.corners);
    const Vec3 normal = polygon_normal(window.corners);
    if (!(std::abs(normal.dot(sun)) > along_plane * normal.length() * sun.length()))
        throw table.error("corners", "the sun must not shine along the window");
    return window;
}

Sun sun_from(const TomlTable& table, const std::vector<TomlTable>& windows) {
    Sun sun;
    sun.direction = table.required("direction", table.vector("direction"));
    if (!(sun.direction.length() > 0)) throw table.error("direction", "must not be a zero vector");
    sun.illuminance = table.required("illuminance", table.rgb("illuminance", TomlLimits::light())) *
                      color_of(table);
    require_light(table, "illuminance", sun.illuminance);
    sun.shaft = table.flag("shaft").value_or(sun.shaft);
    table.finish();
    for (const TomlTable& window : windows)
        sun.windows.push_back(window_from(window, sun.direction));
    return sun;
}

} // namespace

LightRig rig_from(const TomlTable& table) {
    LightRig rig;
    rig.name = table.text("name").value_or("");
    rig.ambient = table.rgb("ambient", TomlLimits::light()).value_or(rig.ambient);
    std::vector<LightSource> sources;
    std::vector<std::pair<std::uint32_t, std::size_t>> order; // by line
    const auto take = [&](const TomlTable& t, LightSource source) {
        order.emplace_back(t.line(), sources.size());
        sources.push_back(std::move(source));
    };
    for (const TomlTable& t : table.tables("c_plane")) take(t, c_plane_from(t));
    for (const TomlTable& t : table.tables("spotlight")) take(t, spotlight_from(t));
    for (const TomlTable& t : table.tables("luminaire")) take(t, luminaire_from(t));
    for (const TomlTable& t : table.tables("polygon")) take(t, polygon_light_from(t));
    for (const TomlTable& t : table.tables("sphere")) take(t, sphere_light_from(t));
    for (const TomlTable& t : table.tables("box"))
        for (PolygonLight& face : box_faces_from(t)) take(t, std::move(face));
    for (const TomlTable& t : table.tables("point")) take(t, point_from(t));
    for (const TomlTable& t : table.tables("line")) take(t, line_from(t));
    const std::vector<TomlTable> windows = table.tables("window");
    const auto sun = table.table("sun");
    if (sun) take(*sun, sun_from(*sun, windows));
    if (!sun && !windows.empty()) {
        table.refuse_misspelt();
        throw table.error("window", "lets in no light without [sun]");
    }
    std::sort(order.begin(), order.end());
    for (const auto& [line, source] : order) rig.sources.push_back(std::move(sources[source]));
    if (const auto fog = table.table("fog")) rig.medium = medium_from(*fog);
    table.not_yet({"sky"});
    return rig;
}

namespace {

/// The rig of a whole file.
LightRig whole_rig(const TomlTable& root) {
    root.require_format(format);
    LightRig rig = rig_from(root);
    root.finish();
    if (rig.sources.empty() && rig.ambient == Rgb(0))
        throw root.error(
            "",
            "the rig has no light: neither [[c_plane]] nor [[spotlight]] nor [[luminaire]] "
            "nor [[polygon]] nor [[sphere]] nor [[box]] nor [[point]] nor [[line]] nor [sun]");
    return rig;
}

} // namespace

LightRig parse_rig(std::string_view text, const std::string& source) {
    return whole_rig(TomlTable::parse(text, source));
}

LightRig parse_rig_alone(std::string_view text, const std::string& source) {
    return whole_rig(TomlTable::parse_alone(text, source));
}

LightRig read_rig(const std::filesystem::path& path) {
    return parse_rig(read_file(path), path.string());
}

namespace {

std::string table_text(const Sun& sun) {
    std::string text = "\n[sun]\n";
    text += toml_line("direction", toml_value(sun.direction), "the way the light goes");
    text += toml_line("illuminance", toml_value(sun.illuminance), "lx across the light");
    if (!sun.shaft) text += toml_line("shaft", "false");
    for (const Window& window : sun.windows)
        text += "\n[[window]]\n" + corners_line(window.corners);
    return text;
}

struct Text {
    const std::filesystem::path& folder;

    std::string operator()(const CPlane& plane) const { return table_text(plane); }
    std::string operator()(const Spotlight& light) const { return table_text(light); }
    std::string operator()(const Luminaire& lamp) const { return table_text(lamp, folder); }
    std::string operator()(const Sun& sun) const { return table_text(sun); }
    std::string operator()(const PointSource& light) const { return table_text(light); }
    template <ExtendedLight Light>
    std::string operator()(const Light& light) const {
        return table_text(light);
    }
};

bool is_sun(const LightSource& source) {
    return std::holds_alternative<Sun>(source);
}

} // namespace

std::string rig_text(const LightRig& rig, const std::filesystem::path& folder) {
    std::string text = toml_line("format", toml_string(format));
    if (!rig.name.empty()) text += toml_line("name", toml_string(rig.name));
    if (rig.ambient != Rgb(0)) text += toml_line("ambient", toml_value(rig.ambient), "lx");
    if (std::count_if(rig.sources.begin(), rig.sources.end(), is_sun) > 1)
        throw Error("", "rig", "holds more than one sun");
    for (const LightSource& source : rig.sources) text += std::visit(Text{folder}, source);
    if (rig.medium) text += table_text(*rig.medium, folder);
    return text;
}

void write_rig(const std::filesystem::path& path, const LightRig& rig) {
    write_text_file(path, rig_text(rig, path.parent_path()));
}

} // namespace keiko
