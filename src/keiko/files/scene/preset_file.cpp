#include "keiko/files/scene/preset_file.h"

#include "keiko/base/input_file.h"
#include "keiko/base/text.h"
#include "keiko/files/toml/toml_reader.h"
#include "keiko/files/toml/toml_text.h"

#include "keiko_standard_files.h"

#include <vector>

namespace keiko {
namespace {

/// Beyond these no limit of a surface makes sense; a mistyped unit does.
constexpr TomlLimits lengths{.low = 0, .high = 1e6, .above_low = true};
constexpr TomlLimits negligible_lengths{.low = 1e-3, .high = 1e3};
constexpr TomlLimits angles{.low = 0, .high = 180, .above_low = true};
constexpr TomlLimits corner_angles{.low = 0, .high = 90, .above_low = true};

/// Sizes of joints, mm.
constexpr TomlLimits joint_gaps{.low = 0, .high = 100};
constexpr TomlLimits joint_steps{.low = -100, .high = 100};
constexpr TomlLimits joint_reaches{.low = 0.1, .high = 100};
constexpr TomlLimits joint_spacings{.low = 0.1, .high = 1000};

/// Largest values that quantities can have: a limit as large judges nothing.
struct LargestValues {
    static constexpr double alias = 1, catia = 2;  ///< mismatch of curvatures, by its formula
    static constexpr double curvature_slope = 180; ///< degrees, between tangents of two plots
    static constexpr double turn = 90, kink = 180; ///< degrees, of lines
};

/// A limit that a quantity of at most `largest` can be beyond.
std::optional<double> limit_below(const TomlTable& table, std::string_view key, double largest) {
    const auto limit = table.number(key, TomlLimits::positive());
    if (limit && !(*limit < largest))
        throw table.error(key, "must be above 0 and below " + toml_number(largest) +
                                   ", which nothing is beyond, is " + toml_number(*limit));
    return limit;
}

CurvatureLimit curvature_from(const TomlTable& table) {
    CurvatureLimit limit;
    const std::size_t formula =
        table.required("formula", table.choice("formula", {"alias", "catia"}));
    const bool is_alias = formula == 0;
    limit.formula = is_alias ? CurvatureFormula::alias : CurvatureFormula::catia;
    const double largest = is_alias ? LargestValues::alias : LargestValues::catia;
    limit.limit = table.required("limit", limit_below(table, "limit", largest));
    table.finish();
    return limit;
}

void read_seam(const TomlTable& table, CriteriaPreset& preset) {
    preset.gap = table.required("gap", table.number("gap", lengths));
    preset.angle = table.required("angle", table.number("angle", angles));
    preset.curvature.reset();
    if (const auto curvature = table.table("curvature"))
        preset.curvature = curvature_from(*curvature);
    preset.curvature_slope = limit_below(table, "curvature_slope", LargestValues::curvature_slope);
    preset.feature_angle = table.number("feature_angle", angles).value_or(preset.feature_angle);
    preset.fading = table.number("fading", TomlLimits::positive()).value_or(preset.angle / 70);
    preset.longest_run_out =
        table.number("longest_run_out", lengths).value_or(preset.longest_run_out);
    preset.negligible = table.number("negligible", negligible_lengths).value_or(preset.negligible);
    preset.flat_radius =
        table.number("flat_radius", TomlLimits::positive()).value_or(preset.flat_radius);
    if (!(preset.feature_angle > preset.angle))
        throw table.error("feature_angle",
                          "is not above the limit of the angle: no seam could fail");
    table.finish();
}

LineLimits line_limits_from(const TomlTable& table) {
    LineLimits limits;
    limits.jump = table.number("jump", lengths);
    limits.turn = limit_below(table, "turn", LargestValues::turn);
    limits.kink = limit_below(table, "kink", LargestValues::kink);
    limits.bend = table.number("bend", TomlLimits::positive());
    table.finish();
    return limits;
}

WavinessLimit waviness_from(const TomlTable& table) {
    WavinessLimit limit;
    limit.depth = table.required("depth", table.number("depth", lengths));
    limit.window = table.required("window", table.number("window", lengths));
    limit.waves_only = table.flag("waves_only").value_or(false);
    if (limit.depth > limit.window / 50)
        throw table.error("depth", "is more than a fiftieth of the window: such is form, no flaw");
    table.finish();
    return limit;
}

/// One, or several by ascending windows.
std::vector<WavinessLimit> waviness_limits_from(const TomlTable& table) {
    if (table.kind("waviness") != "array") {
        const auto waviness = table.table("waviness");
        return waviness ? std::vector{waviness_from(*waviness)} : std::vector<WavinessLimit>{};
    }
    std::vector<WavinessLimit> limits;
    for (const TomlTable& one : table.tables("waviness")) {
        const WavinessLimit limit = waviness_from(one);
        if (!limits.empty() && !(limits.back().window < limit.window))
            throw one.error("window", "is no wider than the one before it");
        limits.push_back(limit);
    }
    return limits;
}

SymmetryLimit symmetry_from(const TomlTable& table) {
    SymmetryLimit limit;
    const std::string plane = table.required("plane", table.text("plane"));
    try {
        limit.plane = MirrorPlane::parse(plane);
    } catch (const Error& error) {
        throw table.error("plane", error.reason());
    }
    limit.distance = table.required("distance", table.number("distance", lengths));
    table.finish();
    return limit;
}

SurfaceLimits surface_limits_from(const TomlTable& table) {
    SurfaceLimits limits;
    limits.minimum_radius = table.number("minimum_radius", lengths);
    limits.waviness = waviness_limits_from(table);
    if (const auto symmetry = table.table("symmetry")) limits.symmetry = symmetry_from(*symmetry);
    table.finish();
    return limits;
}

StructureLimits structure_limits_from(const TomlTable& table) {
    constexpr int most_degree = 100, most_spans = 1000000;
    StructureLimits limits;
    limits.degree = table.integer("degree", 1, most_degree);
    limits.spans = table.integer("spans", 1, most_spans);
    limits.knot_distance = table.number("knot_distance", lengths);
    limits.patch_edge = table.number("patch_edge", lengths);
    limits.degenerate_edge = table.number("degenerate_edge", lengths);
    limits.corner_angle = table.number("corner_angle", corner_angles);
    limits.short_edge = table.number("short_edge", lengths);
    limits.small_face = table.number("small_face", lengths);
    table.finish();
    return limits;
}

NominalSize nominal_from(const TomlTable& table, const TomlLimits& sizes) {
    NominalSize size;
    size.nominal = table.required("nominal", table.number("nominal", sizes));
    size.tolerance = table.required("tolerance", table.number("tolerance", lengths));
    table.finish();
    return size;
}

JointLimits joint_limits_from(const TomlTable& table) {
    JointLimits limits;
    if (const auto gap = table.table("gap")) limits.gap = nominal_from(*gap, joint_gaps);
    if (const auto flush = table.table("flush")) limits.flush = nominal_from(*flush, joint_steps);
    limits.parallelism = table.number("parallelism", lengths);
    limits.radius = table.number("radius", lengths);
    limits.widest = table.number("widest", joint_reaches).value_or(limits.widest);
    limits.largest_radius =
        table.number("largest_radius", joint_reaches).value_or(limits.largest_radius);
    limits.corner_radius = table.number("corner_radius", lengths).value_or(limits.corner_radius);
    limits.spacing = table.number("spacing", joint_spacings).value_or(limits.spacing);
    if (limits.gap && limits.gap->nominal + limits.gap->tolerance >= limits.widest)
        throw table.error("gap", "reaches what is too wide for a joint: no gap could be over it");
    table.finish();
    return limits;
}

LookLimits look_limits_from(const TomlTable& table) {
    LookLimits limits;
    limits.waviness = waviness_limits_from(table);
    table.finish();
    return limits;
}

std::vector<CriteriaPreset> parsed_standard_presets() {
    std::vector<CriteriaPreset> presets;
    for (const StandardPreset& preset : standard_preset_files)
        presets.push_back(parse_preset(preset.text, std::string(preset.name) + ".toml"));
    return presets;
}

} // namespace

CriteriaPreset parse_preset(std::string_view text, const std::string& source) {
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
    root.finish();
    return preset;
}

CriteriaPreset read_preset(const std::filesystem::path& path) {
    return parse_preset(read_file(path), path.string());
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

CriteriaPreset preset_by_name_or_file(const std::string& name_or_file) {
    const std::filesystem::path path(name_or_file);
    if (path.extension() == ".toml" || path.has_parent_path()) return read_preset(path);
    return preset_by_name(name_or_file);
}

} // namespace keiko
