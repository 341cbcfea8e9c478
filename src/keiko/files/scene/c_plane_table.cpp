#include "keiko/base/text.h"
#include "keiko/files/scene/rig_tables.h"
#include "keiko/files/toml/toml_reader.h"
#include "keiko/files/toml/toml_text.h"
#include "keiko/light/luminance/photometry.h"

#include <array>
#include <cmath>
#include <utility>

namespace keiko {

namespace {

template <class T, std::size_t n>
using Words = std::array<std::pair<std::string_view, T>, n>;

/// Without TubeModel::picture and preview, which pictures choose for themselves.
constexpr Words<TubeModel, 6> diffuse_models{{{"automatic", TubeModel::automatic},
                                              {"strip", TubeModel::strip},
                                              {"cylinder", TubeModel::cylinder},
                                              {"rectangle", TubeModel::rectangle},
                                              {"line", TubeModel::line},
                                              {"nishita", TubeModel::nishita}}};
constexpr Words<MirrorModel, 3> mirror_looks{
    {{"tube", MirrorModel::tube}, {"flat", MirrorModel::flat}, {"exact", MirrorModel::exact}}};

/// The value that goes with the word at `key`.
template <class T, std::size_t n>
std::optional<T> named(const TomlTable& table, std::string_view key, const Words<T, n>& words) {
    const std::optional<std::string> typed = table.text(key);
    if (!typed) return {};
    std::vector<std::string> known;
    for (const auto& [word, value] : words) {
        if (*typed == word) return value;
        known.emplace_back(word);
    }
    throw table.error(
        key, "'" + *typed + "' is none of " + comma_list(known) + did_you_mean(*typed, known));
}

template <class T, std::size_t n>
std::string_view word_for(T value, const Words<T, n>& words) {
    for (const auto& [word, known] : words)
        if (known == value) return word;
    throw Error("", "rig", "holds a model that no rig file names");
}

void take_lamp_models(const TomlTable& table, CPlane& plane) {
    if (const auto fidelity = table.choice("fidelity", {"paper", "corrected", "exact"})) {
        constexpr std::array diffuse{TubeModel::nishita, TubeModel::automatic, TubeModel::cylinder};
        constexpr std::array mirror{MirrorModel::flat, MirrorModel::tube, MirrorModel::exact};
        plane.diffuse = diffuse[*fidelity];
        plane.mirror = mirror[*fidelity];
    }
    plane.diffuse = named(table, "diffuse", diffuse_models).value_or(plane.diffuse);
    plane.mirror = named(table, "mirror", mirror_looks).value_or(plane.mirror);
}

std::string_view word_of(TubeModel model) {
    return word_for(model, diffuse_models);
}

std::string_view word_of(MirrorModel look) {
    return word_for(look, mirror_looks);
}

constexpr int most_lamps = 1000;
/// Sine of an angle that counts as none: u and v this square are left as they are, so that a
/// written rig reads back bit for bit.
constexpr double square_enough = 1e-12;
/// Relative length by which rounded numbers may miss "fits exactly".
constexpr double rounding = 1e-9;

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

} // namespace

CPlane c_plane_from(const TomlTable& table) {
    CPlane plane;
    plane.origin = table.required("origin", table.vector("origin"));
    plane.u = table.required("u", table.vector("u"));
    plane.v = table.required("v", table.vector("v"));
    square_up(table, plane);
    plane.lamps = table.integer("lamps", 1, most_lamps).value_or(plane.lamps);
    plane.pitch = table.number("pitch", TomlLimits::length()).value_or(0);
    plane.diameter = table.number("diameter", TomlLimits::length()).value_or(plane.diameter);
    require_room(table, plane);

    if (const auto caps = table.choice("caps", {"dark", "luminous"}))
        plane.luminous_caps = *caps == 1;
    plane.luminance = luminance_from(table, plane.luminance, [&](double flux) {
        return tube_luminance(flux, plane.diameter, plane.u.length(), plane.luminous_caps);
    });
    take_lamp_models(table, plane);
    table.not_yet({"on", "reflector"});
    table.finish();
    return plane;
}

std::string table_text(const CPlane& plane) {
    std::string text = "\n[[c_plane]]\n";
    text += toml_line("origin", toml_value(plane.origin), "mm, corner u = v = 0");
    text += toml_line("u", toml_value(plane.u), "mm, along the lamps");
    text += toml_line("v", toml_value(plane.v), "mm, across the lamps");
    text += toml_line("lamps", std::to_string(plane.lamps));
    if (plane.pitch > 0)
        text += toml_line("pitch", toml_value(plane.pitch), "mm from axis to axis");
    text += toml_line("diameter", toml_value(plane.diameter), "mm");
    if (plane.luminous_caps) text += toml_line("caps", toml_string("luminous"));
    if (plane.diffuse != CPlane{}.diffuse)
        text += toml_line("diffuse", toml_string(word_of(plane.diffuse)));
    if (plane.mirror != CPlane{}.mirror)
        text += toml_line("mirror", toml_string(word_of(plane.mirror)));
    return text + toml_line("luminance", toml_value(plane.luminance), "cd/m2");
}

} // namespace keiko
