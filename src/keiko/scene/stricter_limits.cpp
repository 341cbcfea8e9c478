#include "keiko/scene/stricter_limits.h"

#include <algorithm>
#include <cstdio>

namespace keiko {
namespace {

/// The smaller of two limits from above; none limits nothing.
std::optional<double> smaller(const std::optional<double>& a, const std::optional<double>& b) {
    return a && b ? std::min(*a, *b) : a ? a : b;
}

/// The limit by the formula `catia` under which nothing passes that the limit itself fails. Where
/// (k1 - k2) / (k1 + k2) is a, (k1 - k2) / k1 is 2 a / (1 + a); docs/theory/verdict.md.
double catia_limit(const CurvatureLimit& limit) {
    return limit.formula == CurvatureFormula::catia ? limit.limit
                                                    : 2 * limit.limit / (1 + limit.limit);
}

std::optional<CurvatureLimit> stricter(const std::optional<CurvatureLimit>& a,
                                       const std::optional<CurvatureLimit>& b) {
    if (!a || !b) return a ? a : b;
    if (a->formula == b->formula) return a->limit <= b->limit ? a : b;
    return CurvatureLimit{CurvatureFormula::catia, std::min(catia_limit(*a), catia_limit(*b))};
}

LineLimits stricter(const LineLimits& a, const LineLimits& b) {
    return {smaller(a.jump, b.jump), smaller(a.turn, b.turn), smaller(a.kink, b.kink),
            smaller(a.bend, b.bend)};
}

std::string number(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

/// Limits in words, one after the other, that let more pass than others.
class Comparison {
public:
    /// A limit that values may not exceed.
    void at_most(const char* what, const std::optional<double>& zone,
                 const std::optional<double>& preset, const char* unit = "", double shown = 1) {
        if (preset && !(zone && *zone <= *preset)) add(what, zone, *preset, unit, shown);
    }
    /// A limit that values may not fall below.
    void at_least(const char* what, const std::optional<double>& zone,
                  const std::optional<double>& preset, const char* unit) {
        if (preset && !(zone && *zone >= *preset)) add(what, zone, *preset, unit, 1);
    }
    void curvature(const std::optional<CurvatureLimit>& zone,
                   const std::optional<CurvatureLimit>& preset) {
        constexpr double percent = 100;
        constexpr const char* what = "curvature mismatch";
        const auto limit_of = [](const CurvatureLimit& limit) {
            return std::optional(limit.limit);
        };
        if (!preset) return;
        if (!zone || zone->formula == preset->formula) {
            at_most(what, zone ? limit_of(*zone) : std::nullopt, limit_of(*preset), " %", percent);
            return;
        }
        if (catia_limit(*zone) > catia_limit(*preset))
            add((std::string(what) + " by another formula").c_str(), limit_of(*zone), preset->limit,
                " %", percent);
    }
    void draft(const std::optional<DraftLimit>& zone, const std::optional<DraftLimit>& preset) {
        if (!preset) return;
        const bool same = zone && zone->pull == preset->pull;
        if (same && zone->angle >= preset->angle) return;
        add(zone && !same ? "draft against another pull" : "draft",
            zone ? std::optional(zone->angle) : std::nullopt, preset->angle, " degrees", 1);
    }
    void waviness(const std::vector<WavinessLimit>& zone, const WavinessLimit& preset) {
        const std::string what = "dents and waves in " + number(preset.window) + " mm";
        const auto same = std::find_if(zone.begin(), zone.end(), [&](const WavinessLimit& limit) {
            return limit.window == preset.window && (preset.waves_only || !limit.waves_only);
        });
        at_most(what.c_str(), same == zone.end() ? std::nullopt : std::optional(same->depth),
                preset.depth, " mm");
    }
    std::vector<std::string> take() { return std::move(words_); }

private:
    void add(const std::string& what, const std::optional<double>& zone, double preset,
             const char* unit, double shown) {
        words_.push_back(what + " " + (zone ? number(*zone * shown) + unit : "not judged") +
                         " instead of " + number(preset * shown) + unit);
    }

    std::vector<std::string> words_;
};

std::optional<double> real(const std::optional<int>& number) {
    return number ? std::optional<double>(*number) : std::nullopt;
}

void compare_spans(const StructureLimits& own, const StructureLimits& all, Comparison& than) {
    than.at_most("degree", real(own.degree), real(all.degree));
    than.at_most("number of spans", real(own.spans), real(all.spans));
    than.at_least("width of a knot span", own.knot_distance, all.knot_distance, " mm");
    than.at_most("ratio of widths of spans", own.width_ratio, all.width_ratio);
    than.at_least("edge of a patch", own.patch_edge, all.patch_edge, " mm");
    than.at_least("degenerate edge", own.degenerate_edge, all.degenerate_edge, " mm");
    than.at_least("angle at a corner", own.corner_angle, all.corner_angle, " degrees");
    than.at_most("turn of control points", own.control_turn, all.control_turn, " degrees");
    than.at_most("twist of control points", own.control_twist, all.control_twist, " degrees");
    than.at_most("ratio of legs of control points", own.control_ratio, all.control_ratio);
    than.at_least("distance of control points", own.control_distance, all.control_distance, " mm");
}

void compare_edges(const StructureLimits& own, const StructureLimits& all, Comparison& than) {
    than.at_least("edge of a face", own.short_edge, all.short_edge, " mm");
    than.at_least("size of a face", own.small_face, all.small_face, " mm");
    than.at_least("distance of faces", own.identical_face, all.identical_face, " mm");
    than.at_least("distance of edges", own.identical_edge, all.identical_edge, " mm");
    than.at_least("distance of a face from itself", own.self_distance, all.self_distance, " mm");
    than.at_most("crossing of a loop", own.loop_crossing, all.loop_crossing, " mm");
    than.at_most("gap between edges", own.edge_gap, all.edge_gap, " mm");
    than.at_most("kink of an edge", own.edge_angle, all.edge_angle, " degrees");
    than.at_most("degree of an edge", real(own.edge_degree), real(all.edge_degree));
    than.at_least("curve of an edge", own.edge_knot_distance, all.edge_knot_distance, " mm");
}

} // namespace

CriteriaPreset stricter_limits(const CriteriaPreset& a, const CriteriaPreset& b) {
    CriteriaPreset limits = a;
    limits.gap = std::min(a.gap, b.gap), limits.angle = std::min(a.angle, b.angle);
    limits.curvature = stricter(a.curvature, b.curvature);
    limits.curvature_slope = smaller(a.curvature_slope, b.curvature_slope);
    limits.fading = std::min(a.fading, b.fading);
    limits.lines = stricter(a.lines, b.lines);
    return limits;
}

std::vector<std::string> looser_limits(const CriteriaPreset& zone, const CriteriaPreset& preset) {
    Comparison than;
    than.at_most("gap", zone.gap, preset.gap, " mm");
    than.at_most("angle", zone.angle, preset.angle, " degrees");
    than.curvature(zone.curvature, preset.curvature);
    than.at_most("slope of the curvature", zone.curvature_slope, preset.curvature_slope,
                 " degrees");
    than.at_most("fading", zone.fading, preset.fading, " degrees/mm");
    than.at_most("jump of lines", zone.lines.jump, preset.lines.jump, " mm");
    than.at_most("turn of lines", zone.lines.turn, preset.lines.turn, " degrees");
    than.at_most("kink of lines", zone.lines.kink, preset.lines.kink, " degrees");
    than.at_most("bend of lines", zone.lines.bend, preset.lines.bend, " /mm");
    than.at_least("radius", zone.surface.minimum_radius, preset.surface.minimum_radius, " mm");
    than.draft(zone.surface.draft, preset.surface.draft);
    for (const WavinessLimit& limit : preset.surface.waviness)
        than.waviness(zone.surface.waviness, limit);
    compare_spans(zone.structure, preset.structure, than);
    compare_edges(zone.structure, preset.structure, than);
    return than.take();
}

} // namespace keiko
