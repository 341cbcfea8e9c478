#include "keiko/files/scene/preset_file.h"

#include "keiko/base/input_file.h"
#include "keiko/base/text.h"
#include "keiko/files/scene/limit_tables.h"
#include "keiko/files/scene/zone_table.h"
#include "keiko/files/toml/toml_reader.h"

#include "keiko_standard_files.h"

#include <vector>

namespace keiko {
namespace {

constexpr TomlLimits negligible_lengths{.low = 1e-3, .high = 1e3};

/// Sizes of joints, mm.
constexpr TomlLimits joint_gaps{.low = 0, .high = 100};
constexpr TomlLimits joint_steps{.low = -100, .high = 100};
constexpr TomlLimits joint_reaches{.low = 0.1, .high = 100};
constexpr TomlLimits joint_spacings{.low = 0.1, .high = 1000};

void read_seam(const TomlTable& table, CriteriaPreset& preset) {
    read_seam_limits(table, preset);
    preset.feature_angle =
        table.number("feature_angle", limit_angles).value_or(preset.feature_angle);
    preset.longest_run_out =
        table.number("longest_run_out", limit_lengths).value_or(preset.longest_run_out);
    preset.negligible = table.number("negligible", negligible_lengths).value_or(preset.negligible);
    preset.flat_radius =
        table.number("flat_radius", TomlLimits::positive()).value_or(preset.flat_radius);
    if (!(preset.feature_angle > preset.angle))
        throw table.error("feature_angle",
                          "is not above the limit of the angle: no seam could fail");
    table.finish();
}

NominalSize nominal_from(const TomlTable& table, const TomlLimits& sizes) {
    NominalSize size;
    size.nominal = table.required("nominal", table.number("nominal", sizes));
    size.tolerance = table.required("tolerance", table.number("tolerance", limit_lengths));
    table.finish();
    return size;
}

JointLimits joint_limits_from(const TomlTable& table) {
    JointLimits limits;
    if (const auto gap = table.table("gap")) limits.gap = nominal_from(*gap, joint_gaps);
    if (const auto flush = table.table("flush")) limits.flush = nominal_from(*flush, joint_steps);
    limits.parallelism = table.number("parallelism", limit_lengths);
    limits.radius = table.number("radius", limit_lengths);
    limits.widest = table.number("widest", joint_reaches).value_or(limits.widest);
    limits.largest_radius =
        table.number("largest_radius", joint_reaches).value_or(limits.largest_radius);
    limits.corner_radius =
        table.number("corner_radius", limit_lengths).value_or(limits.corner_radius);
    limits.spacing = table.number("spacing", joint_spacings).value_or(limits.spacing);
    if (limits.gap && limits.gap->nominal + limits.gap->tolerance >= limits.widest)
        throw table.error("gap", "reaches what is too wide for a joint: no gap could be over it");
    table.finish();
    return limits;
}

std::vector<CriteriaPreset> parsed_standard_presets() {
    std::vector<CriteriaPreset> presets;
    for (const StandardPreset& preset : standard_preset_files)
        presets.push_back(parse_preset(preset.text, std::string(preset.name) + ".toml"));
    return presets;
}

/// Whether a file may have zones. One whose limits zones of another file take may not.
enum class ZonesOf { preset, none };

CriteriaPreset parsed(std::string_view text, const std::string& source, ZonesOf zones);

/// The limits that a zone takes from a preset by its name, or from another file.
CriteriaPreset limits_named(const TomlTable& zone) {
    const std::string name = zone.required("preset", zone.text("preset"));
    if (std::filesystem::path(name).extension() == ".toml") {
        const std::filesystem::path path = readable_path(zone, "preset", name);
        return parsed(read_text_file(path), path.string(), ZonesOf::none);
    }
    try {
        return preset_by_name(name);
    } catch (const Error& error) {
        throw zone.error("preset", error.reason());
    }
}

CriteriaPreset parsed(std::string_view text, const std::string& source, ZonesOf zones) {
    const TomlTable root = TomlTable::parse(text, source);
    root.require_format("keiko-preset/1");
    CriteriaPreset preset;
    preset.name = root.required("name", root.text("name"));
    if (preset.name.empty()) throw root.error("name", "is empty");
    preset.source = root.text("source").value_or("");
    preset.caveat = root.text("caveat").value_or("");
    read_seam(root.required("seam", root.table("seam")), preset);
    const auto lines = root.table("lines");
    preset.lines = lines ? line_limits_from(*lines) : LineLimits{};
    if (const auto surface = root.table("surface")) preset.surface = surface_limits_from(*surface);
    if (const auto structure = root.table("structure"))
        preset.structure = structure_limits_from(*structure);
    if (const auto look = root.table("look")) {
        preset.look = look_limits_from(*look);
        if (!preset.look.waviness.empty() && !preset.surface.waviness.empty())
            throw look->error("waviness", "has no use where [surface] limits it");
    }
    const auto joint = root.table("joint");
    preset.joint = joint ? joint_limits_from(*joint) : JointLimits{};
    if (zones == ZonesOf::none && root.has("zone"))
        throw root.error("zone", "has no place in a preset that a zone takes its limits from");
    preset.zones = zones_from(root, preset);
    root.finish();
    return preset;
}

} // namespace

std::vector<Zone> zones_from(const TomlTable& root, const CriteriaPreset& preset) {
    return zones_from(root, preset, limits_named);
}

CriteriaPreset parse_preset(std::string_view text, const std::string& source) {
    return parsed(text, source, ZonesOf::preset);
}

CriteriaPreset read_preset(const std::filesystem::path& path) {
    return parse_preset(read_text_file(path), path.string());
}

std::span<const CriteriaPreset> standard_presets() {
    static const std::vector<CriteriaPreset> presets = parsed_standard_presets();
    return presets;
}

const CriteriaPreset& preset_by_name(std::string_view name) {
    std::vector<std::string> names;
    for (const CriteriaPreset& preset : standard_presets()) {
        if (preset.name == name) return preset;
        names.push_back(preset.name);
    }
    throw Error("", "",
                "unknown preset '" + shortened(name) + "'" + did_you_mean(name, names) +
                    "; there are " + comma_list(names) + ", or the path of a .toml file");
}

bool is_preset_path(const std::string& name_or_file) {
    const std::filesystem::path path(name_or_file);
    return path.extension() == ".toml" || path.has_parent_path();
}

CriteriaPreset preset_by_name_or_file(const std::string& name_or_file) {
    if (is_preset_path(name_or_file)) return read_preset(name_or_file);
    return preset_by_name(name_or_file);
}

} // namespace keiko
