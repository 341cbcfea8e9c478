#include "keiko/stream/source_columns.h"

#include <array>
#include <string_view>
#include <variant>

namespace keiko {

std::vector<std::string> source_columns(const LightRig& rig) {
    // In the order of LightSource.
    constexpr std::array<std::string_view, std::variant_size_v<LightSource>> kinds{
        "c_plane", "spotlight", "luminaire", "sun",     "polygon",   "sphere", "point",
        "line",    "sky",       "disc",      "frustum", "ellipsoid", "body"};
    static_assert(!kinds.back().empty(), "each kind of light has a name");
    std::array<int, kinds.size()> counts{};
    std::vector<std::string> columns;
    for (const LightSource& source : rig.sources) {
        const std::size_t kind = source.index();
        columns.push_back(std::string(kinds[kind]) + "." + std::to_string(counts[kind]++));
    }
    return columns;
}

} // namespace keiko
