#include "keiko/film/film.h"

#include "keiko/base/error.h"

#include <array>

namespace keiko {
namespace {

struct AovName {
    Aov aov;
    std::string_view name;
    std::vector<std::string> channels;
};

const std::array<AovName, 9>& aov_names() {
    static const std::array<AovName, 9> names{
        {{Aov::luminance, "luminance", {"Y"}},
         {Aov::normal, "normal", {"X", "Y", "Z"}},
         {Aov::uv, "uv", {"u", "v"}},
         {Aov::face, "face", {"id"}},
         {Aov::patch, "patch", {"id"}},
         {Aov::depth, "depth", {"Z"}},
         {Aov::c_plane_uv, "c_plane_uv", {"u", "v"}},
         {Aov::illuminance, "illuminance", {"E"}},
         {Aov::curvature, "curvature", {"k1", "k2", "mean", "gauss"}}}};
    return names;
}

const AovName& entry(Aov aov) {
    for (const AovName& known : aov_names())
        if (known.aov == aov) return known;
    throw Error("", "", "unknown AOV");
}

} // namespace

const std::vector<Aov>& every_aov() {
    static const std::vector<Aov> all = [] {
        std::vector<Aov> aovs;
        for (const AovName& known : aov_names()) aovs.push_back(known.aov);
        return aovs;
    }();
    return all;
}

std::string_view name_of(Aov aov) {
    return entry(aov).name;
}

std::vector<std::string> channel_names(Aov aov) {
    return entry(aov).channels;
}

Aov aov_by_name(std::string_view name) {
    std::string list;
    for (const AovName& known : aov_names()) {
        if (known.name == name) return known.aov;
        list += (list.empty() ? "" : ", ") + std::string(known.name);
    }
    throw Error("", "aov", "no AOV is called " + in_quotes(name) + "; there are " + list);
}

} // namespace keiko
