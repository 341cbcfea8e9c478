#include "keiko/report/content/luminaire_facts.h"

#include "keiko/base/text.h"
#include "keiko/light/rig/luminaire_remarks.h"
#include "keiko/light/spotlight/luminous_flux.h"
#include "keiko/report/content/inspection_texts.h"
#include "keiko/report/markup/html_text.h"
#include "keiko/report/markup/json_text.h"

#include <cmath>
#include <string_view>
#include <utility>

namespace keiko {
namespace {

constexpr double half = 0.5, tenth = 0.1;

std::string_view name_of(PhotometricType type) {
    switch (type) {
        case PhotometricType::a:
            return "A";
        case PhotometricType::b:
            return "B";
        case PhotometricType::c:
            break;
    }
    return "C";
}

std::string_view name_of(PlaneSymmetry symmetry) {
    switch (symmetry) {
        case PlaneSymmetry::none:
            return "none";
        case PlaneSymmetry::axial:
            return "axial";
        case PlaneSymmetry::quadrant:
            return "about planes 0-180 and 90-270";
        case PlaneSymmetry::bilateral:
            return "about plane 0-180";
        case PlaneSymmetry::bilateral_across:
            return "about plane 90-270";
        case PlaneSymmetry::lateral:
            return "left and right";
        case PlaneSymmetry::limited:
            break;
    }
    return "none";
}

/// Vertical and horizontal angle of the first largest value of the table.
std::pair<double, double> brightest(const IntensityTable& table) {
    for (std::size_t h = 0; h < table.horizontal().size(); ++h)
        for (std::size_t v = 0; v < table.vertical().size(); ++v)
            if (table.value(h, v) == table.largest())
                return {table.vertical()[v], table.horizontal()[h]};
    return {0, 0};
}

Json angles_json(const std::vector<double>& degrees) {
    return {{"count", degrees.size()}, {"first", degrees.front()}, {"last", degrees.back()}};
}

/// Largest difference in degrees between the halves of a beam that is called symmetric.
constexpr double symmetric_within = 0.05;
constexpr int digits = 6;

/// Names of a principal plane and of its sides.
struct PlaneNames {
    std::string_view plane, positive, negative;
};

PlaneNames names_of(PhotometricType type, int plane) {
    if (type == PhotometricType::c)
        return plane == 0 ? PlaneNames{"C0-C180", "C0", "C180"}
                          : PlaneNames{"C90-C270", "C90", "C270"};
    return plane == 0 ? PlaneNames{"horizontal", "H > 0", "H < 0"}
                      : PlaneNames{"vertical", "V > 0", "V < 0"};
}

std::string degrees(double angle) {
    return short_number(angle, digits) + " degrees";
}

/// Edges of a beam that lies on one side alone, `near` with a negative angle.
std::string one_sided_text(const SpreadEdge& near, const SpreadEdge& far, std::string_view side) {
    return (near.reached ? "from " : "from at most ") + short_number(-near.angle, digits) +
           (far.reached ? " to " : " degrees, not reached within ") + degrees(far.angle) +
           " towards " + std::string(side);
}

std::string edge_text(const SpreadEdge& edge, std::string_view side) {
    return (edge.reached ? "" : "not reached within ") + degrees(edge.angle) + " towards " +
           std::string(side);
}

std::string edges_text(const BeamSpread& spread, const PlaneNames& names) {
    const auto& [positive, negative, opposite] = spread;
    if (negative.angle < 0) return one_sided_text(negative, positive, names.positive);
    if (positive.angle < 0) return one_sided_text(positive, negative, names.negative);
    return edge_text(positive, names.positive) + ", " + edge_text(negative, names.negative);
}

std::string spread_words(const BeamSpread& spread, const PlaneNames& names) {
    const auto& [positive, negative, opposite] = spread;
    const bool symmetric = std::abs(positive.angle - negative.angle) <= symmetric_within &&
                           positive.reached == negative.reached;
    if (symmetric && !positive.reached) return "not reached within " + degrees(positive.angle);
    const auto full = spread.full_angle();
    if (!full) return edges_text(spread, names);
    return degrees(*full) + (symmetric ? "" : ": " + edges_text(spread, names));
}

Json edge_json(const SpreadEdge& edge) {
    return {{"degrees", edge.angle}, {"reached", edge.reached}};
}

Json edges_of(const std::optional<BeamSpread>& spread) {
    if (!spread) return nullptr;
    return {{"positive", edge_json(spread->positive)},
            {"negative", edge_json(spread->negative)},
            {"opposite", spread->opposite}};
}

Json full_angle_of(const std::optional<BeamSpread>& spread) {
    const auto full = spread ? spread->full_angle() : std::nullopt;
    return full ? Json(*full) : Json();
}

Json full_angles_json(const PrincipalSpreads& spreads) {
    return {{"plane_0", full_angle_of(spreads.plane_0)},
            {"plane_90", full_angle_of(spreads.plane_90)}};
}

Json edges_json(const PrincipalSpreads& spreads) {
    return {{"plane_0", edges_of(spreads.plane_0)}, {"plane_90", edges_of(spreads.plane_90)}};
}

} // namespace

LuminaireFacts luminaire_facts(const std::string& source, PhotometricWeb web) {
    LuminaireFacts facts{.source = source, .web = std::move(web)};
    facts.flux = luminous_flux(facts.web);
    facts.largest_intensity = facts.web.candela.largest();
    facts.beam = principal_spreads(facts.web, half);
    facts.field = principal_spreads(facts.web, tenth);
    facts.diagnostics = flux_contradictions(source, facts.web);
    return facts;
}

std::string luminaire_text(const LuminaireFacts& facts) {
    const IntensityTable& table = facts.web.candela;
    const auto [v, h] = brightest(table);
    TextLines lines;
    lines.line("file") << facts.source;
    if (!facts.web.name.empty()) lines.line("luminaire") << facts.web.name;
    lines.line("type") << name_of(facts.web.type) << ", symmetry " << name_of(table.symmetry());
    lines.line("angles") << table.vertical().size() << " from " << table.vertical().front()
                         << " to " << table.vertical().back() << " degrees in "
                         << table.horizontal().size() << " planes";
    std::ostream& flux = lines.line("flux");
    flux << facts.flux << " lm";
    if (facts.web.lamp_flux > 0)
        flux << ", " << 100 * facts.flux / facts.web.lamp_flux << " % of its lamps' "
             << facts.web.lamp_flux << " lm";
    lines.line("intensity") << "at most " << facts.largest_intensity << " cd, under " << v
                            << " degrees in plane " << h;
    const PhotometricType type = facts.web.type;
    lines.line("beam angle") << spread_text(type, 0, facts.beam.plane_0);
    lines.line("") << spread_text(type, 90, facts.beam.plane_90);
    lines.line("field angle") << spread_text(type, 0, facts.field.plane_0);
    lines.line("") << spread_text(type, 90, facts.field.plane_90);
    for (const FoldedRemark& remark : folded_remarks(facts.diagnostics))
        lines.line(name_of(remark.severity)) << remark.text;
    return lines.text();
}

std::string luminaire_json(const LuminaireFacts& facts) {
    const PhotometricWeb& web = facts.web;
    const auto [v, h] = brightest(web.candela);
    const bool relative = web.lamp_flux > 0;
    const Json json = {{"format", "keiko-luminaire-facts/1"},
                       {"source", facts.source},
                       {"name", web.name},
                       {"photometric_type", name_of(web.type)},
                       {"symmetry", name_of(web.candela.symmetry())},
                       {"planes", angles_json(web.candela.horizontal())},
                       {"vertical_angles", angles_json(web.candela.vertical())},
                       {"luminous_flux", facts.flux},
                       {"lamp_flux", relative ? Json(web.lamp_flux) : Json()},
                       {"light_output_ratio", relative ? Json(facts.flux / web.lamp_flux) : Json()},
                       {"largest_intensity",
                        {{"candela", facts.largest_intensity}, {"vertical", v}, {"plane", h}}},
                       {"beam_angle", full_angles_json(facts.beam)},
                       {"beam_edges", edges_json(facts.beam)},
                       {"field_angle", full_angles_json(facts.field)},
                       {"field_edges", edges_json(facts.field)},
                       {"opening", point(web.opening)},
                       {"diagnostics", diagnostics_json(facts.diagnostics)}};
    return text_of(json);
}

std::string spread_text(PhotometricType type, int plane, const std::optional<BeamSpread>& spread) {
    const PlaneNames names = names_of(type, plane);
    const std::string begin = std::string(names.plane) + ": ";
    if (!spread) return begin + "dark";
    return begin + spread_words(*spread, names) + (spread->opposite ? ", about the zenith" : "");
}

} // namespace keiko
