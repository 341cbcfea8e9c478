#include "keiko/files/scene/zone_table.h"

#include "keiko/base/text.h"
#include "keiko/files/scene/limit_tables.h"

#include <algorithm>
#include <string>

namespace keiko {
namespace {

/// More make no sense, and limits of each pair are kept.
constexpr std::size_t most_zones = 64;

std::string name_from(const TomlTable& table, const std::vector<Zone>& before) {
    std::string name = table.required("name", table.text("name"));
    if (name.empty()) throw table.error("name", "is empty");
    if (name == outer_skin) throw table.error("name", "is that of the scope that is found");
    if (std::any_of(before.begin(), before.end(),
                    [&](const Zone& zone) { return zone.name == name; }))
        throw table.error("name", "'" + shortened(name) + "' is that of an earlier zone");
    return name;
}

/// One text or more, none of them empty.
std::vector<std::string> words_from(const TomlTable& table, std::string_view key) {
    if (!table.has(key)) return {};
    std::vector<std::string> words = *table.texts(key);
    if (words.empty()) throw table.error(key, "must name at least one");
    if (std::any_of(words.begin(), words.end(),
                    [](const std::string& word) { return word.empty(); }))
        throw table.error(key, "holds an empty name");
    return words;
}

std::vector<FaceColor> colors_from(const TomlTable& table) {
    std::vector<FaceColor> colors;
    for (const std::string& word : words_from(table, "colors")) {
        try {
            colors.push_back(FaceColor::parse(word));
        } catch (const Error& error) {
            throw table.error("colors", error.reason());
        }
    }
    return colors;
}

std::optional<Box3> box_from(const TomlTable& table) {
    const auto corners = table.lists("box", TomlLimits::place());
    if (!corners) return {};
    constexpr std::size_t dimensions = 3;
    if (corners->size() != 2 || corners->front().size() != dimensions ||
        corners->back().size() != dimensions)
        throw table.error("box", "must be two corners, [[x, y, z], [x, y, z]]");
    Box3 box;
    for (unsigned i = 0; i < dimensions; ++i) {
        box.lower[i] = corners->front()[i], box.upper[i] = corners->back()[i];
        if (!(box.lower[i] < box.upper[i]))
            throw table.error("box", "must have its lower corner first, and be a box");
    }
    return box;
}

FaceSelection selection_from(const TomlTable& table) {
    FaceSelection selection;
    selection.faces = words_from(table, "faces");
    selection.layers = words_from(table, "layers");
    selection.colors = colors_from(table);
    selection.box = box_from(table);
    selection.visible = table.number("visible", {.low = 0, .high = 1, .above_low = true});
    if (!selection.is_empty()) return selection;
    table.refuse_misspelt();
    throw table.error("", "selects no faces: it needs faces, layers, colors, box or visible");
}

/// A preset's limits with all that zones share taken from another.
CriteriaPreset limits_shared_with(const CriteriaPreset& preset, CriteriaPreset limits) {
    limits.name = preset.name, limits.source = preset.source, limits.caveat = preset.caveat;
    limits.feature_angle = preset.feature_angle, limits.longest_run_out = preset.longest_run_out;
    limits.negligible = preset.negligible, limits.flat_radius = preset.flat_radius;
    limits.surface.symmetry = preset.surface.symmetry, limits.look = preset.look;
    limits.zones.clear();
    return limits;
}

void read_seam(const TomlTable& table, CriteriaPreset& limits) {
    for (const char* shared : {"feature_angle", "longest_run_out", "negligible", "flat_radius"})
        if (table.has(shared))
            throw table.error(shared,
                              "is the same in all zones: it belongs to the preset's [seam]");
    read_seam_limits(table, limits);
    table.finish();
}

void read_surface(const TomlTable& table, CriteriaPreset& limits) {
    if (table.has("symmetry"))
        throw table.error("symmetry", "is of the body as a whole: it belongs to [surface]");
    const auto symmetry = limits.surface.symmetry;
    limits.surface = surface_limits_from(table);
    limits.surface.symmetry = symmetry;
}

CriteriaPreset limits_from(const TomlTable& table, const CriteriaPreset& preset,
                           const PresetOfZone& named) {
    CriteriaPreset limits = limits_shared_with(preset, table.has("preset") ? named(table) : preset);
    if (const auto seam = table.table("seam")) read_seam(*seam, limits);
    if (const auto lines = table.table("lines")) limits.lines = line_limits_from(*lines);
    if (const auto surface = table.table("surface")) read_surface(*surface, limits);
    if (const auto structure = table.table("structure"))
        limits.structure = structure_limits_from(*structure);
    if (!(limits.angle < preset.feature_angle))
        throw table.error("",
                          "has an angle that is not below the feature angle of the preset: no "
                          "seam could fail");
    return limits;
}

} // namespace

std::vector<Zone> zones_from(const TomlTable& root, const CriteriaPreset& preset,
                             const PresetOfZone& named) {
    std::vector<Zone> zones;
    for (const TomlTable& table : root.tables("zone")) {
        if (zones.size() == most_zones)
            throw table.error(
                "", "is one too many: there are at most " + std::to_string(most_zones) + " zones");
        Zone zone;
        zone.name = name_from(table, zones), zone.file = table.source().string();
        zone.selection = selection_from(table);
        zone.limits = limits_from(table, preset, named);
        table.finish();
        zones.push_back(std::move(zone));
    }
    return zones;
}

} // namespace keiko
