#include "keiko/io/rig_file.h"

#include "keiko/base/input_file.h"
#include "keiko/base/output_file.h"
#include "keiko/io/lamp_models.h"
#include "keiko/io/toml_reader.h"
#include "keiko/luminance/photometry.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace keiko {
namespace {

constexpr std::string_view format = "keiko-rig/1";
constexpr int most_lamps = 1000;
/// Sine of an angle that counts as none: u and v this square are left as they are, so that a
/// written rig reads back bit for bit.
constexpr double square_enough = 1e-12;
/// Relative length by which rounded numbers may miss "fits exactly".
constexpr double rounding = 1e-9;

Rgb color_of(const TomlTable& table) {
    return table.rgb("color", TomlLimits::not_negative()).value_or(Rgb(1));
}

/// `light` is a product of finite numbers.
void require_finite(const TomlTable& table, std::string_view key, const Rgb& light) {
    if (!std::isfinite(light.r + light.g + light.b)) throw table.error(key, "is too bright");
}

void square_up(const TomlTable& table, CPlane& plane) {
    const double u = plane.u.length(), v = plane.v.length();
    if (!(u > 0)) throw table.error("u", "must not be a zero vector");
    if (!(v > 0)) throw table.error("v", "must not be a zero vector");
    const double sine = plane.u.cross(plane.v).length() / (u * v);
    if (!(sine > 1e-6)) throw table.error("v", "must not be parallel to u");
    if (std::abs(plane.u.dot(plane.v)) > square_enough * u * v)
        plane.v -= plane.u * (plane.u.dot(plane.v) / plane.u.length2());
}

void require_room(const TomlTable& table, const CPlane& plane) {
    const double comb = (plane.lamps - 1) * plane.spacing() + plane.diameter;
    const double width = plane.v.length();
    if (plane.spacing() * (1 + rounding) < plane.diameter && plane.lamps > 1)
        throw table.error(plane.pitch > 0 ? "pitch" : "lamps",
                          "lamps of diameter " + toml_number(plane.diameter) +
                              " mm overlap at a pitch of " + toml_number(plane.spacing()) + " mm");
    if (comb > width * (1 + rounding))
        throw table.error("lamps", std::to_string(plane.lamps) + " lamps need " +
                                       toml_number(comb) + " mm, but v is " + toml_number(width) +
                                       " mm long");
}

CPlane c_plane_from(const TomlTable& table) {
    CPlane plane;
    plane.origin = table.required("origin", table.vector("origin"));
    plane.u = table.required("u", table.vector("u"));
    plane.v = table.required("v", table.vector("v"));
    square_up(table, plane);
    plane.lamps = table.integer("lamps", 1, most_lamps).value_or(plane.lamps);
    plane.pitch = table.number("pitch", TomlLimits::positive()).value_or(0);
    plane.diameter = table.number("diameter", TomlLimits::positive()).value_or(plane.diameter);
    require_room(table, plane);

    const auto luminance = table.rgb("luminance", TomlLimits::not_negative());
    const auto flux = table.number("luminous_flux", TomlLimits::not_negative());
    if (luminance && flux)
        throw table.error("luminous_flux", "give either luminance or luminous_flux, not both");
    if (luminance) plane.luminance = *luminance;
    if (const auto caps = table.choice("caps", {"dark", "luminous"}))
        plane.luminous_caps = *caps == 1;
    if (flux)
        plane.luminance =
            Rgb(tube_luminance(*flux, plane.diameter, plane.u.length(), plane.luminous_caps));
    plane.luminance *= color_of(table);
    require_finite(table, flux ? "luminous_flux" : "color", plane.luminance);
    take_lamp_models(table, plane);
    table.not_yet({"on", "reflector"});
    table.finish();
    return plane;
}

Spotlight spotlight_from(const TomlTable& table) {
    Spotlight spot;
    spot.position = table.required("position", table.vector("position"));
    spot.aim = table.required("aim", table.vector("aim"));
    if (spot.aim == spot.position) throw table.error("aim", "must differ from position");
    spot.half_angle = table.number("half_angle", {.low = 0, .high = 180, .above_low = true})
                          .value_or(spot.half_angle);
    if (table.text("edge") == "table") throw table.error("edge", "'table' is not supported yet");
    EdgeProfile profile;
    if (const auto edge = table.choice("edge", {"sharp", "soft", "mixed"}))
        profile.edge = static_cast<BeamEdge>(*edge);
    profile.q = table.number("q", TomlLimits::share()).value_or(profile.q);
    if (table.has("q") && profile.edge != BeamEdge::mixed)
        throw table.error("q", "belongs to edge = \"mixed\" alone");
    spot.profile = profile;
    spot.intensity = table.rgb("intensity", TomlLimits::not_negative()).value_or(spot.intensity) *
                     color_of(table);
    require_finite(table, "color", spot.intensity);
    table.not_yet({"reference", "pattern", "shaft", "file"});
    table.finish();
    return spot;
}

Sun sun_from(const TomlTable& table) {
    Sun sun;
    sun.direction = table.required("direction", table.vector("direction"));
    if (!(sun.direction.length() > 0)) throw table.error("direction", "must not be a zero vector");
    sun.illuminance =
        table.required("illuminance", table.rgb("illuminance", TomlLimits::not_negative())) *
        color_of(table);
    require_finite(table, "color", sun.illuminance);
    table.not_yet({"window"});
    table.finish();
    return sun;
}

double phase_from(const TomlTable& table) {
    const auto kind = table.choice("kind", {"isotropic", "fog", "henyey-greenstein"});
    const bool fog = table.required("kind", kind) == 1;
    if (*kind == 2) throw table.error("kind", "'henyey-greenstein' is not supported yet");
    const auto k = table.number("k", TomlLimits::not_negative());
    if (!fog && k) throw table.error("k", "belongs to kind = \"fog\" alone");
    table.finish();
    return fog ? table.required("k", k) : 0;
}

Medium medium_from(const TomlTable& table) {
    Medium medium;
    medium.extinction =
        table.required("extinction", table.rgb("extinction", TomlLimits::not_negative()));
    medium.albedo = table.rgb("albedo", TomlLimits::share()).value_or(medium.albedo);
    medium.ambient = table.rgb("ambient", TomlLimits::not_negative()).value_or(medium.ambient);
    if (const auto phase = table.table("phase")) medium.phase_k = phase_from(*phase);
    table.not_yet({"layer", "density", "file"});
    table.finish();
    return medium;
}

} // namespace

LightRig rig_from(const TomlTable& table) {
    LightRig rig;
    rig.name = table.text("name").value_or("");
    rig.ambient = table.rgb("ambient", TomlLimits::not_negative()).value_or(rig.ambient);
    std::vector<std::pair<std::uint32_t, LightSource>> sources;
    for (const TomlTable& t : table.tables("c_plane"))
        sources.emplace_back(t.line(), c_plane_from(t));
    for (const TomlTable& t : table.tables("spotlight"))
        sources.emplace_back(t.line(), spotlight_from(t));
    if (const auto sun = table.table("sun")) sources.emplace_back(sun->line(), sun_from(*sun));
    std::stable_sort(sources.begin(), sources.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (auto& [line, source] : sources) rig.sources.push_back(std::move(source));
    if (const auto fog = table.table("fog")) rig.medium = medium_from(*fog);
    table.not_yet({"luminaire", "window", "point", "line", "polygon", "sky"});
    return rig;
}

LightRig parse_rig(std::string_view text, const std::string& source) {
    const TomlTable root = TomlTable::parse(text, source);
    root.require_format(format);
    LightRig rig = rig_from(root);
    root.finish();
    if (rig.sources.empty() && rig.ambient == Rgb(0))
        throw root.error("",
                         "the rig has no light: neither [[c_plane]] nor [[spotlight]] nor [sun]");
    return rig;
}

LightRig read_rig(const std::filesystem::path& path) {
    return parse_rig(read_file(path), path.string());
}

namespace {

std::string number(double value) {
    if (!std::isfinite(value)) throw Error("", "rig", "holds a number that is not finite");
    return toml_number(value);
}

std::string array(double a, double b, double c) {
    return std::string("[") + number(a) + ", " + number(b) + ", " + number(c) + "]";
}

std::string array(const Vec3& v) {
    return array(v.x, v.y, v.z);
}

std::string grey_or_array(const Rgb& c) {
    return c.r == c.g && c.g == c.b ? number(c.r) : array(c.r, c.g, c.b);
}

/// A TOML string with the characters escaped that it must not hold.
std::string toml_string(std::string_view text) {
    constexpr std::string_view digits = "0123456789ABCDEF";
    std::string result = "\"";
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (code < 0x20 || code == 0x7f) {
            result += {'\\', 'u', '0', '0', digits[code >> 4], digits[code & 15]};
            continue;
        }
        if (c == '"' || c == '\\') result += '\\';
        result += c;
    }
    return result + "\"";
}

std::string line(std::string_view key, const std::string& value, std::string_view comment = "") {
    std::string text = std::string(key) + " = " + value;
    if (!comment.empty()) text += " # " + std::string(comment);
    return text + "\n";
}

std::string table_text(const CPlane& plane) {
    std::string text = "\n[[c_plane]]\n";
    text += line("origin", array(plane.origin), "mm, corner u = v = 0");
    text += line("u", array(plane.u), "mm, along the lamps");
    text += line("v", array(plane.v), "mm, across the lamps");
    text += line("lamps", std::to_string(plane.lamps));
    if (plane.pitch > 0) text += line("pitch", number(plane.pitch), "mm from axis to axis");
    text += line("diameter", number(plane.diameter), "mm");
    if (plane.luminous_caps) text += line("caps", toml_string("luminous"));
    if (plane.diffuse != CPlane{}.diffuse)
        text += line("diffuse", toml_string(word_of(plane.diffuse)));
    if (plane.mirror != CPlane{}.mirror) text += line("mirror", toml_string(word_of(plane.mirror)));
    return text + line("luminance", grey_or_array(plane.luminance), "cd/m2");
}

/// Whether the keys of a [[spotlight]] tell all of it.
bool has_keys(const Spotlight& spot) {
    const Spotlight plain;
    return std::holds_alternative<EdgeProfile>(spot.profile) && spot.pattern == plain.pattern &&
           spot.reference == plain.reference && spot.spin == plain.spin &&
           !spot.half_angle_across && !spot.hue && spot.shaft;
}

std::string table_text(const Spotlight& spot) {
    static constexpr std::string_view edges[] = {"sharp", "soft", "mixed"};
    if (!has_keys(spot))
        throw Error("", "rig", "holds a spotlight that rig files have no keys for");
    const auto& profile = std::get<EdgeProfile>(spot.profile);
    std::string text = "\n[[spotlight]]\n";
    text += line("position", array(spot.position), "mm");
    text += line("aim", array(spot.aim), "mm");
    text += line("half_angle", number(spot.half_angle), "degrees from the axis to the rim");
    text += line("edge", toml_string(edges[static_cast<std::size_t>(profile.edge)]));
    if (profile.edge == BeamEdge::mixed) text += line("q", number(profile.q));
    return text + line("intensity", grey_or_array(spot.intensity), "cd on the axis");
}

std::string table_text(const Sun& sun) {
    std::string text = "\n[sun]\n";
    text += line("direction", array(sun.direction), "the way the light goes");
    return text + line("illuminance", grey_or_array(sun.illuminance), "lx across the light");
}

std::string table_text(const Medium& medium) {
    std::string text = "\n[fog]\n";
    text += line("extinction", grey_or_array(medium.extinction), "1/m");
    text += line("albedo", grey_or_array(medium.albedo));
    text += line("ambient", grey_or_array(medium.ambient), "cd/m2");
    if (medium.phase_k > 0)
        text += line("phase", "{ kind = \"fog\", k = " + number(medium.phase_k) + " }");
    return text;
}

bool is_sun(const LightSource& source) {
    return std::holds_alternative<Sun>(source);
}

} // namespace

std::string rig_text(const LightRig& rig) {
    std::string text = line("format", toml_string(format));
    if (!rig.name.empty()) text += line("name", toml_string(rig.name));
    if (rig.ambient != Rgb(0)) text += line("ambient", grey_or_array(rig.ambient), "lx");
    if (std::count_if(rig.sources.begin(), rig.sources.end(), is_sun) > 1)
        throw Error("", "rig", "holds more than one sun");
    for (const LightSource& source : rig.sources)
        text += std::visit([](const auto& kind) { return table_text(kind); }, source);
    if (rig.medium) text += table_text(*rig.medium);
    return text;
}

void write_rig(const std::filesystem::path& path, const LightRig& rig) {
    write_text_file(path, rig_text(rig));
}

} // namespace keiko
