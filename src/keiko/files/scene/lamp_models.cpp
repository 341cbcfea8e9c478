#include "keiko/files/scene/lamp_models.h"

#include "keiko/base/text.h"
#include "keiko/files/toml/toml_reader.h"

#include <array>
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

} // namespace

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

} // namespace keiko
