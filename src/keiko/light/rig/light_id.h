#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace keiko {

/// Number of a single light of a rig: one lamp of a row, one panel of a sky, or any other source.
struct LightId {
    std::size_t source = 0; ///< index into LightRig::sources
    int lamp = 0;           ///< by rising v, or of a panel; 0 of a source that is one light
};

/// Lights by rising source, then lamp, a source at a time: `visit(source, lamps, first)` receives
/// the numbers of its lamps and the index of their first among the lights.
template <class Visit>
void each_source(std::span<const LightId> lights, const Visit& visit) {
    for (std::size_t i = 0; i < lights.size();) {
        const std::size_t first = i, source = lights[i].source;
        std::vector<int> lamps;
        lamps.reserve(lights.size() - i);
        for (; i < lights.size() && lights[i].source == source; ++i)
            lamps.push_back(lights[i].lamp);
        visit(source, lamps, first);
    }
}

} // namespace keiko
