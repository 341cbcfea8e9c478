#include "keiko/files/photometric/intensity_csv.h"
#include "keiko/files/scene/rig_tables.h"
#include "keiko/files/toml/toml_reader.h"
#include "keiko/files/toml/toml_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

namespace keiko {

namespace {

constexpr std::array<std::string_view, 3> readings{"centred", "rounded", "literal"};
constexpr double most_periods = 3600;
constexpr TomlLimits coefficients{.low = -1e15, .high = 1e15};
/// Share of a period by which rounded numbers may miss "divides 360".
constexpr double rounding = 1e-9;

TomlLimits below_one() {
    return {.low = -1e6, .high = std::nextafter(1.0, 0.0)};
}

/// How often the period `dphi` goes into a turn.
int periods_from(const TomlTable& table) {
    const double dphi =
        table.required("dphi", table.number("dphi", {.low = 360 / most_periods, .high = 360}));
    const double count = std::round(360 / dphi);
    if (std::abs(count * dphi - 360) > rounding * 360)
        throw table.error("dphi", "must divide 360, is " + toml_number(dphi));
    return static_cast<int>(count);
}

Petals petals_from(const TomlTable& table) {
    Petals petals;
    petals.count = periods_from(table);
    petals.q = table.number("q", below_one()).value_or(petals.q);
    return petals;
}

Dots dots_from(const TomlTable& table) {
    Dots dots;
    const int columns = periods_from(table);
    if (columns % 2 != 0)
        throw table.error("dphi",
                          "must divide 360 an even number of times, or two lit columns "
                          "meet at phi = 0");
    dots.dphi = 360.0 / columns;
    dots.dtheta =
        table.required("dtheta", table.number("dtheta", {.low = 360 / most_periods, .high = 180}));
    const double q = table.number("q", below_one()).value_or(0);
    dots.q_phi = table.number("q_phi", below_one()).value_or(q);
    dots.q_theta = table.number("q_theta", below_one()).value_or(q);
    if (const auto reading = table.choice("reading", {readings[0], readings[1], readings[2]}))
        dots.reading = static_cast<DotReading>(*reading);
    return dots;
}

struct Text {
    std::string operator()(std::monostate) const { return ""; }
    std::string operator()(const Petals& petals) const {
        return "kind = \"radial\", dphi = " + toml_value(360.0 / petals.count) +
               ", q = " + toml_value(petals.q);
    }
    std::string operator()(const Dots& dots) const {
        return "kind = \"dots\", dphi = " + toml_value(dots.dphi) +
               ", dtheta = " + toml_value(dots.dtheta) + ", q_phi = " + toml_value(dots.q_phi) +
               ", q_theta = " + toml_value(dots.q_theta) +
               ", reading = " + toml_string(readings[static_cast<std::size_t>(dots.reading)]);
    }
    std::string operator()(const PhiPolynomial& polynomial) const {
        return "kind = \"polynomial\", coefficients = " +
               toml_value(polynomial.in_cosine.coefficients);
    }
};

void take_pattern(const TomlTable& pattern, Spotlight& light) {
    light.hue = pattern.flag("hue").value_or(light.hue);
    switch (pattern.choice("kind", {"plain", "radial", "dots", "polynomial"}).value_or(0)) {
        case 1:
            light.pattern = petals_from(pattern);
            break;
        case 2:
            light.pattern = dots_from(pattern);
            break;
        case 3:
            light.pattern = PhiPolynomial{
                {pattern.required("coefficients", pattern.list("coefficients", coefficients))}};
            break;
        default:
            break;
    }
    pattern.finish();
}

std::string pattern_text(const Spotlight& light) {
    std::string text = std::visit(Text(), light.pattern);
    if (light.hue) text += (text.empty() ? "" : ", ") + std::string("hue = true");
    return text.empty() ? "" : toml_line("pattern", "{ " + text + " }");
}

constexpr std::array<std::string_view, 3> edges{"sharp", "soft", "mixed"};
constexpr std::array<std::string_view, 2> interpolations{"linear", "cosine"};
/// Degrees: of narrower beams doubles tell no profile.
constexpr double narrowest = 1e-3;

IntensityColumns columns_from(const TomlTable& table) {
    IntensityColumns columns;
    columns.theta = table.required("theta", table.list("theta"));
    columns.phi = table.list("phi").value_or(columns.phi);
    columns.values =
        table.required("values", table.lists("values", {.high = TomlLimits::light().high}));
    table.finish();
    if (const std::string fault = table_fault(columns); !fault.empty())
        throw table.error("", fault);
    return columns;
}

TableProfile table_profile_from(const TomlTable& table) {
    auto interpolation = TableInterpolation::cosine;
    if (const auto word = table.choice("interpolation", {interpolations[0], interpolations[1]}))
        interpolation = static_cast<TableInterpolation>(*word);
    const auto file = path_from(table, "file");
    const auto inline_table = table.table("table");
    if (file && inline_table) throw table.error("file", "give either file or table, not both");
    IntensityColumns columns =
        file ? read_intensity_csv(*file) : columns_from(table.required("table", inline_table));
    return std::make_shared<const IntensityTable>(
        intensity_table(std::move(columns), interpolation));
}

/// A key of another kind of edge, or none, says that the edge was misspelt or forgotten.
void require_absent(const TomlTable& table, std::initializer_list<std::string_view> keys,
                    const std::string& owner) {
    for (const std::string_view key : keys)
        if (table.has(key)) throw table.error(key, "belongs to edge = \"" + owner + "\" alone");
}

BeamProfile profile_from(const TomlTable& table) {
    const std::size_t edge =
        table.choice("edge", {edges[0], edges[1], edges[2], "power", "polynomial", "table"})
            .value_or(1);
    if (edge != 2) require_absent(table, {"q"}, "mixed");
    if (edge != 3) require_absent(table, {"exponent"}, "power");
    if (edge != 4) require_absent(table, {"coefficients"}, "polynomial");
    if (edge != 5) require_absent(table, {"table", "file", "interpolation"}, "table");
    if (edge == 3)
        return CosinePower{
            table.required("exponent", table.number("exponent", {.low = 0, .high = 1e6}))};
    if (edge == 4)
        return CosinePolynomial{
            table.required("coefficients", table.list("coefficients", coefficients))};
    if (edge == 5) return table_profile_from(table);
    EdgeProfile profile{static_cast<BeamEdge>(edge)};
    profile.q = table.number("q", TomlLimits::share()).value_or(profile.q);
    return profile;
}

/// To where the profile has light of its own accord; the papers' edges have none and take that of
/// the struct.
double own_half_angle(const Spotlight& light) {
    if (const auto* table = std::get_if<TableProfile>(&light.profile))
        return std::max((*table)->lit_up_to(), narrowest);
    if (std::holds_alternative<CosinePower>(light.profile)) return 90;
    if (std::holds_alternative<CosinePolynomial>(light.profile)) return 180;
    return light.half_angle;
}

struct ProfileText {
    std::string operator()(const EdgeProfile& profile) const {
        const auto edge = static_cast<std::size_t>(profile.edge);
        std::string text = toml_line("edge", toml_string(edges[edge]));
        if (profile.edge == BeamEdge::mixed) text += toml_line("q", toml_value(profile.q));
        return text;
    }
    std::string operator()(const CosinePower& warn) const {
        return toml_line("edge", toml_string("power")) +
               toml_line("exponent", toml_value(warn.exponent));
    }
    std::string operator()(const CosinePolynomial& polynomial) const {
        return toml_line("edge", toml_string("polynomial")) +
               toml_line("coefficients", toml_value(polynomial.coefficients));
    }
    std::string operator()(const TableProfile& table) const {
        const auto interpolation = static_cast<std::size_t>(table->interpolation());
        return toml_line("edge", toml_string("table")) +
               toml_line("interpolation", toml_string(interpolations[interpolation])) +
               toml_line("table", "{ theta = " + toml_value(table->vertical()) +
                                      ", phi = " + toml_value(table->horizontal()) +
                                      ", values = " + columns_text(*table) + " }");
    }

private:
    static std::string columns_text(const IntensityTable& table) {
        std::string text;
        for (std::size_t h = 0; h < table.horizontal().size(); ++h) {
            std::vector<double> column;
            for (std::size_t v = 0; v < table.vertical().size(); ++v)
                column.push_back(table.value(h, v));
            text += (h == 0 ? "" : ", ") + toml_value(column);
        }
        return "[" + text + "]";
    }
};

} // namespace

void take_beam(const TomlTable& table, Spotlight& light) {
    light.profile = profile_from(table);
    const auto half = table.number("half_angle", {.low = narrowest, .high = 180});
    light.half_angle = half.value_or(own_half_angle(light));
    light.half_angle_across = table.number("half_angle_across", {.low = narrowest, .high = 89});
    if (light.half_angle_across && light.half_angle > 89)
        throw table.error("half_angle_across", "needs a half_angle of at most 89");
    if (const auto pattern = table.table("pattern")) take_pattern(*pattern, light);
}

std::string beam_text(const Spotlight& light) {
    std::string text =
        toml_line("half_angle", toml_value(light.half_angle), "degrees from the axis to the rim");
    if (light.half_angle_across)
        text += toml_line("half_angle_across", toml_value(*light.half_angle_across),
                          "the same under phi = 90 degrees");
    return text + std::visit(ProfileText(), light.profile) + pattern_text(light);
}

} // namespace keiko
