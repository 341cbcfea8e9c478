#include "keiko/light/rig/light_id.h"

#include <numeric>

namespace keiko {

std::vector<int> lamp_numbers(const LightSource& source) {
    const auto* row = std::get_if<CPlane>(&source);
    std::vector<int> numbers(row ? static_cast<std::size_t>(row->lamps) : 1);
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
}

std::vector<LightId> lights_of(const LightRig& rig) {
    std::vector<LightId> lights;
    for (std::size_t i = 0; i < rig.sources.size(); ++i)
        for (const int lamp : lamp_numbers(rig.sources[i])) lights.push_back({i, lamp});
    return lights;
}

} // namespace keiko
