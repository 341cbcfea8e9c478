#include "keiko/files/scene/rig_file.h"

#include "keiko/base/input_file.h"
#include "keiko/base/output_file.h"
#include "keiko/files/scene/rig_tables.h"
#include "keiko/files/toml/toml_reader.h"
#include "keiko/files/toml/toml_text.h"
#include "keiko/light/rig/body_lamps.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace keiko {
namespace {

constexpr std::string_view format = "keiko-rig/1";

/// Sun and sky of a rig.
struct Daylight {
    std::optional<std::pair<Sun, std::uint32_t>> sun;      ///< and its line
    std::optional<std::pair<SkyLight, std::uint32_t>> sky; ///< and its line
};

Daylight daylight_from(const TomlTable& table) {
    Daylight light;
    const auto place = table.table("place"), sun = table.table("sun"), sky = table.table("sky");
    const std::vector<TomlTable> openings = table.tables("window");
    if (!sun && !sky && (place || !openings.empty())) {
        table.refuse_misspelt();
        if (place) throw table.error("place", "lights nothing without [sun] or [sky]");
        throw table.error("window", "lets in no light without [sun] or [sky]");
    }
    std::optional<Vec3> towards;
    if (place) towards = direction_to_sun_from(*place);
    if (sun) light.sun.emplace(sun_from(*sun, towards), sun->line());
    if (light.sun) towards = light.sun->first.towards();
    if (sky) light.sky.emplace(sky_light_from(*sky, towards), sky->line());
    const std::vector<Window> windows =
        windows_from(openings, light.sun ? towards : std::optional<Vec3>());
    if (light.sun) light.sun->first.windows = windows;
    if (light.sky) light.sky->first.windows = windows;
    return light;
}

} // namespace

LightRig rig_from(const TomlTable& table) {
    LightRig rig;
    rig.name = table.text("name").value_or("");
    rig.ambient = table.rgb("ambient", TomlLimits::light()).value_or(rig.ambient);
    std::vector<LightSource> sources;
    std::vector<std::pair<std::uint32_t, std::size_t>> order; // by line
    const auto take_at = [&](std::uint32_t line, LightSource source) {
        order.emplace_back(line, sources.size());
        sources.push_back(std::move(source));
    };
    const auto take = [&](const TomlTable& t, LightSource source) {
        take_at(t.line(), std::move(source));
    };
    for (const TomlTable& t : table.tables("c_plane")) take(t, c_plane_from(t));
    for (const TomlTable& t : table.tables("spotlight")) take(t, spotlight_from(t));
    for (const TomlTable& t : table.tables("luminaire")) take(t, luminaire_from(t));
    for (const TomlTable& t : table.tables("polygon"))
        if (!t.has("map")) // which makes a part of the scene of it
            take(t, polygon_light_from(t));
    for (const TomlTable& t : table.tables("sphere")) take(t, sphere_light_from(t));
    for (const TomlTable& t : table.tables("box"))
        for (LightSource& face : box_lights_from(t)) take(t, std::move(face));
    for (const TomlTable& t : table.tables("primitive"))
        if (!t.has("material")) // which makes a part of the scene of it
            for (LightSource& light : primitive_lights_from(t)) take(t, std::move(light));
    for (const TomlTable& t : table.tables("sign")) {
        rig.signs.push_back(sign_from(t));
        for (PolygonLight& panel : rig.signs.back().panels()) take(t, std::move(panel));
    }
    for (const TomlTable& t : table.tables("point")) take(t, point_from(t));
    for (const TomlTable& t : table.tables("line")) take(t, line_from(t));
    const Daylight daylight = daylight_from(table);
    if (daylight.sun) take_at(daylight.sun->second, daylight.sun->first);
    if (daylight.sky) take_at(daylight.sky->second, daylight.sky->first);
    std::sort(order.begin(), order.end());
    for (const auto& [line, source] : order) rig.sources.push_back(std::move(sources[source]));
    if (const auto fog = table.table("fog")) rig.medium = medium_from(*fog);
    return rig;
}

namespace {

/// The rig of a whole file.
LightRig whole_rig(const TomlTable& root) {
    root.require_format(format);
    LightRig rig = rig_from(root);
    for (const TomlTable& table : root.tables("primitive"))
        if (table.has("material"))
            throw table.error("material", "belongs to scenes: a lamp of a rig has a luminance");
    for (const TomlTable& table : root.tables("polygon"))
        if (table.has("map"))
            throw table.error("map", "belongs to scenes: a panel of a rig is alike all over");
    root.finish();
    if (rig.sources.empty() && rig.ambient == Rgb(0))
        throw root.error(
            "",
            "the rig has no light: neither [[c_plane]] nor [[spotlight]] nor [[luminaire]] "
            "nor [[polygon]] nor [[sphere]] nor [[box]] nor [[primitive]] nor [[sign]] "
            "nor [[point]] nor [[line]] nor [sun] nor [sky]");
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
    return parse_rig(read_text_file(path), path.string());
}

namespace {

struct Text {
    const std::filesystem::path& folder;

    std::string operator()(const CPlane& plane) const { return table_text(plane); }
    std::string operator()(const Spotlight& light) const { return table_text(light); }
    std::string operator()(const Luminaire& lamp) const { return table_text(lamp, folder); }
    std::string operator()(const Sun& sun) const { return table_text(sun); }
    std::string operator()(const SkyLight& sky) const { return table_text(sky); }
    std::string operator()(const PointSource& light) const { return table_text(light); }
    /// Lights of bodies stand in no file.
    std::string operator()(const ContourLight& /*light*/) const { return ""; }
    template <ExtendedLight Light>
    std::string operator()(const Light& light) const {
        return table_text(light);
    }
};

/// The signs by the place of their first panel among the sources; one without its panels is none.
std::map<std::size_t, const LuminousSign*> placed_signs(const LightRig& rig) {
    std::map<std::size_t, const LuminousSign*> placed;
    const auto is_panel = [](const LightSource& source, const PolygonLight& panel) {
        const auto* light = std::get_if<PolygonLight>(&source);
        return light && *light == panel;
    };
    auto begin = rig.sources.begin(); // signs are in the order of their panels
    for (const LuminousSign& sign : rig.signs) {
        const std::vector<PolygonLight> panels = sign.panels();
        const auto found =
            std::search(begin, rig.sources.end(), panels.begin(), panels.end(), is_panel);
        if (found == rig.sources.end()) continue;
        begin = found + static_cast<std::ptrdiff_t>(panels.size());
        placed.emplace(static_cast<std::size_t>(found - rig.sources.begin()), &sign);
    }
    return placed;
}

/// Tables of all sources but those of bodies, in their order; a sign stands for its panels.
std::string sources_text(const LightRig& rig, const std::filesystem::path& folder) {
    const auto signs = placed_signs(rig);
    std::string text;
    for (std::size_t i = 0; i < rig.sources.size();) {
        if (is_body_lamp(rig.sources[i])) {
            ++i;
            continue;
        }
        const auto sign = signs.find(i);
        text += sign == signs.end() ? std::visit(Text{folder}, rig.sources[i])
                                    : table_text(*sign->second);
        i += sign == signs.end() ? 1 : 1 + sign->second->legend.size();
    }
    return text;
}

/// The only source of a kind that a file has one of; null if there is none. Throws Error for more.
template <class Kind>
const Kind* only_one(const LightRig& rig, const std::string& name) {
    const Kind* only = nullptr;
    for (const LightSource& source : rig.sources)
        if (const auto* found = std::get_if<Kind>(&source)) {
            if (only) throw Error("", "rig", "holds more than one " + name);
            only = found;
        }
    return only;
}

std::string windows_text(const LightRig& rig) {
    const Sun* sun = only_one<Sun>(rig, "sun");
    const SkyLight* sky = only_one<SkyLight>(rig, "sky");
    if (sun && sky && sun->windows != sky->windows)
        throw Error("", "rig", "holds a sun and a sky behind different windows");
    if (!sun && !sky) return "";
    return windows_text(sun ? sun->windows : sky->windows);
}

} // namespace

std::string rig_text(const LightRig& rig, const std::filesystem::path& folder) {
    std::string text = toml_line("format", toml_string(format));
    if (!rig.name.empty()) text += toml_line("name", toml_string(rig.name));
    if (rig.ambient != Rgb(0)) text += toml_line("ambient", toml_value(rig.ambient), "lx");
    text += sources_text(rig, folder);
    text += windows_text(rig);
    if (rig.medium) text += table_text(*rig.medium, folder);
    return text;
}

void write_rig(const std::filesystem::path& path, const LightRig& rig) {
    write_text_file(path, rig_text(rig, path.parent_path()));
}

} // namespace keiko
