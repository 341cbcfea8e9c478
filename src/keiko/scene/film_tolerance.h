#pragma once

#include <string>
#include <vector>

namespace keiko {

/// How far apart one layer of two pictures may be.
struct LayerTolerance {
    double relative = 0; ///< share of the larger of the two values
    double absolute = 0; ///< in the layer's unit; added to the relative part
    double allowed = 0;  ///< share of the compared pixels that may be farther apart
    double hard = 0;     ///< tolerances that no pixel may be apart; at least 1

    bool operator==(const LayerTolerance&) const = default;
};

/// How far apart two pictures may be.
struct FilmTolerance {
    LayerTolerance color{2e-3, 1e-2, 2e-3, 100};      ///< cd/m2, the channel that differs most
    LayerTolerance normal{0, 0.01, 2e-3, 100};        ///< degrees between the normals
    LayerTolerance depth{1e-6, 1e-3, 2e-3, 100};      ///< mm
    LayerTolerance uv{0, 1e-5, 2e-3, 100};            ///< patch parameters
    LayerTolerance c_plane_uv{1e-5, 0.1, 5e-3, 1000}; ///< mm on the C-plane
    double flips = 2e-3; ///< share of the pixels whose first surface may be another

    bool operator==(const FilmTolerance&) const = default;
};

} // namespace keiko
