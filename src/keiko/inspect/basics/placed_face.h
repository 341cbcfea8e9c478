#pragma once

#include <cstdint>

namespace keiko {

/// A face placed by an instance.
struct PlacedFace {
    std::uint32_t instance = 0, face = 0; ///< into SurfaceModel::instances and ::faces

    bool operator==(const PlacedFace&) const = default;
};

} // namespace keiko
