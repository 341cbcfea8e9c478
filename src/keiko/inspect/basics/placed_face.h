#pragma once

#include "keiko/geometry/model/surface_model.h"

#include <cstdint>
#include <vector>

namespace keiko {

/// A face placed by an instance.
struct PlacedFace {
    std::uint32_t instance = 0, face = 0; ///< into SurfaceModel::instances and ::faces

    bool operator==(const PlacedFace&) const = default;
};

/// Every face of a model as its instances place it: by instance, then by face.
inline std::vector<PlacedFace> placed_faces(const SurfaceModel& model) {
    std::vector<PlacedFace> placed;
    for (std::uint32_t i = 0; i < model.instances.size(); ++i) {
        const Part& part = model.parts[model.instances[i].part];
        for (std::uint32_t f = 0; f < part.face_count; ++f)
            placed.push_back({i, part.first_face + f});
    }
    return placed;
}

} // namespace keiko
