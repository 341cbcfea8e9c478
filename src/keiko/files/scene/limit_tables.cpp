#include "keiko/files/scene/limit_tables.h"

#include "keiko/files/toml/toml_text.h"

namespace keiko {
namespace {

constexpr TomlLimits ratios{.low = 1};
constexpr TomlLimits corner_angles{.low = 0, .high = 90, .above_low = true};

/// Largest values that quantities can have: a limit as large judges nothing.
struct LargestValues {
    static constexpr double alias = 1, catia = 2;  ///< mismatch of curvatures, by its formula
    static constexpr double curvature_slope = 180; ///< degrees, between tangents of two plots
    static constexpr double turn = 90, kink = 180; ///< degrees, of lines; of edges as of lines
    static constexpr double control_angle = 180;   ///< degrees, between legs of a control net
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

WavinessLimit waviness_from(const TomlTable& table) {
    WavinessLimit limit;
    limit.depth = table.required("depth", table.number("depth", limit_lengths));
    limit.window = table.required("window", table.number("window", limit_lengths));
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
    limit.distance = table.required("distance", table.number("distance", limit_lengths));
    table.finish();
    return limit;
}

std::optional<DraftLimit> draft_from(const TomlTable& table) {
    const auto angle = table.number("draft", {.low = 0, .high = 90});
    const auto pull = table.vector("pull");
    if (!angle && pull) throw table.error("pull", "is the direction of a draft, which is missing");
    if (!angle) return std::nullopt;
    DraftLimit limit{.angle = *angle};
    if (!pull) return limit;
    if (!(pull->length() > 0)) throw table.error("pull", "has no direction");
    limit.pull = pull->normalized();
    return limit;
}

} // namespace

void read_seam_limits(const TomlTable& table, CriteriaPreset& preset) {
    preset.gap = table.required("gap", table.number("gap", limit_lengths));
    preset.angle = table.required("angle", table.number("angle", limit_angles));
    preset.curvature.reset();
    if (const auto curvature = table.table("curvature"))
        preset.curvature = curvature_from(*curvature);
    preset.curvature_slope = limit_below(table, "curvature_slope", LargestValues::curvature_slope);
    preset.fading = table.number("fading", TomlLimits::positive()).value_or(preset.angle / 70);
}

LineLimits line_limits_from(const TomlTable& table) {
    LineLimits limits;
    limits.jump = table.number("jump", limit_lengths);
    limits.turn = limit_below(table, "turn", LargestValues::turn);
    limits.kink = limit_below(table, "kink", LargestValues::kink);
    limits.bend = table.number("bend", TomlLimits::positive());
    table.finish();
    return limits;
}

SurfaceLimits surface_limits_from(const TomlTable& table) {
    SurfaceLimits limits;
    limits.minimum_radius = table.number("minimum_radius", limit_lengths);
    limits.waviness = waviness_limits_from(table);
    limits.draft = draft_from(table);
    if (const auto symmetry = table.table("symmetry")) limits.symmetry = symmetry_from(*symmetry);
    table.finish();
    return limits;
}

namespace {

constexpr int most_degree = 100;

/// Limits of knot spans and of their control points.
void read_span_limits(const TomlTable& table, StructureLimits& limits) {
    constexpr int most_spans = 1000000;
    limits.degree = table.integer("degree", 1, most_degree);
    limits.spans = table.integer("spans", 1, most_spans);
    limits.knot_distance = table.number("knot_distance", limit_lengths);
    limits.width_ratio = table.number("width_ratio", ratios);
    limits.patch_edge = table.number("patch_edge", limit_lengths);
    limits.degenerate_edge = table.number("degenerate_edge", limit_lengths);
    limits.corner_angle = table.number("corner_angle", corner_angles);
    limits.control_turn = limit_below(table, "control_turn", LargestValues::control_angle);
    limits.control_twist = limit_below(table, "control_twist", LargestValues::control_angle);
    limits.control_ratio = table.number("control_ratio", ratios);
    limits.control_distance = table.number("control_distance", limit_lengths);
}

/// Limits of edges, and of faces as a whole.
void read_edge_limits(const TomlTable& table, StructureLimits& limits) {
    limits.short_edge = table.number("short_edge", limit_lengths);
    limits.small_face = table.number("small_face", limit_lengths);
    limits.identical_face = table.number("identical_face", limit_lengths);
    limits.identical_edge = table.number("identical_edge", limit_lengths);
    limits.self_distance = table.number("self_distance", limit_lengths);
    limits.loop_crossing = table.number("loop_crossing", limit_lengths);
    limits.edge_gap = table.number("edge_gap", limit_lengths);
    limits.edge_angle = limit_below(table, "edge_angle", LargestValues::kink);
    limits.edge_degree = table.integer("edge_degree", 1, most_degree);
    limits.edge_knot_distance = table.number("edge_knot_distance", limit_lengths);
}

} // namespace

StructureLimits structure_limits_from(const TomlTable& table) {
    StructureLimits limits;
    read_span_limits(table, limits);
    read_edge_limits(table, limits);
    table.finish();
    return limits;
}

LookLimits look_limits_from(const TomlTable& table) {
    LookLimits limits;
    limits.waviness = waviness_limits_from(table);
    table.finish();
    return limits;
}

} // namespace keiko
