#include "keiko/radiosity/lamp_levels.h"

#include <type_traits>
#include <utility>
#include <variant>

namespace keiko {
namespace {

/// Number that the light of a source is proportional to.
template <class Source>
auto& level_of(Source& source) {
    using Kind = std::remove_const_t<Source>;
    if constexpr (std::is_same_v<Kind, Luminaire>)
        return source.factor;
    else if constexpr (std::is_same_v<Kind, Sun>)
        return source.illuminance;
    else if constexpr (requires { source.intensity; })
        return source.intensity;
    else
        return source.luminance;
}

double ratio(double part, double whole) {
    return whole > 0 ? part / whole : 0;
}

} // namespace

std::vector<Rgb> levels_of(const LightRig& rig) {
    std::vector<Rgb> levels;
    for (const LightSource& source : rig.sources)
        levels.push_back(std::visit([](const auto& light) { return level_of(light); }, source));
    return levels;
}

LightRig at_unit_levels(LightRig rig) {
    for (LightSource& source : rig.sources) {
        if (auto* sky = std::get_if<SkyLight>(&source)) {
            const Rgb &part = sky->ground, &whole = sky->luminance;
            sky->ground = {ratio(part.r, whole.r), ratio(part.g, whole.g), ratio(part.b, whole.b)};
        }
        std::visit([](auto& light) { level_of(light) = Rgb(1); }, source);
    }
    return rig;
}

} // namespace keiko
