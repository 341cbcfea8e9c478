#include "keiko/files/scene/pattern_table.h"

#include "keiko/files/toml/toml_reader.h"
#include "keiko/files/toml/toml_text.h"

#include <array>
#include <cmath>

namespace keiko {
namespace {

constexpr std::array<std::string_view, 3> readings{"centred", "rounded", "literal"};
constexpr double most_periods = 3600;
constexpr TomlLimits coefficients{.low = -1e15, .high = 1e15};
/// Of a period: what rounded numbers may miss "divides 360" by.
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

} // namespace

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

} // namespace keiko
