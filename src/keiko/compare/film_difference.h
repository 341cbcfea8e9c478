#pragma once

#include "keiko/film/film.h"

#include <string>
#include <vector>

namespace keiko {

/// How far apart one layer of two pictures may be.
struct LayerTolerance {
    double relative = 0; ///< share of the larger of the two values
    double absolute = 0; ///< in the layer's unit; added to the relative part
    double allowed = 0;  ///< share of the compared pixels that may be farther apart
    double hard = 0;     ///< tolerances that no pixel may be apart; at least 1
};

/// How far apart two pictures may be.
struct FilmTolerance {
    LayerTolerance color{2e-3, 1e-2, 2e-3, 100};      ///< cd/m2, the channel that differs most
    LayerTolerance normal{0, 0.01, 2e-3, 100};        ///< degrees between the normals
    LayerTolerance depth{1e-6, 1e-3, 2e-3, 100};      ///< mm
    LayerTolerance uv{0, 1e-5, 2e-3, 100};            ///< patch parameters
    LayerTolerance c_plane_uv{1e-5, 0.1, 5e-3, 1000}; ///< mm on the C-plane
    double flips = 2e-3; ///< share of the pixels whose first surface may be another
};

/// One layer of two pictures where both show the same surface.
struct LayerDifference {
    std::string layer;           ///< "color", or the name of an AOV
    std::size_t beyond = 0;      ///< pixels farther apart than the tolerance
    double largest = 0;          ///< in the layer's unit; infinity where one is no number
    double excess = 0;           ///< the largest, in tolerances
    double root_mean_square = 0; ///< over the compared pixels
    int x = 0, y = 0;            ///< pixel of the largest excess, the first of equals
    bool within = true;
};

/// How far apart two pictures are.
struct FilmDifference {
    std::size_t pixels = 0, compared = 0;
    std::size_t coverage_flips = 0; ///< pixels in which the outline moved
    std::size_t face_flips = 0;     ///< others whose centre shows another face
    bool flips_within = true;
    std::vector<LayerDifference> layers;
    Image excess; ///< 1 channel: the largest excess of any layer, infinity in flipped pixels

    bool within() const;
};

/// Compares the colour and the AOVs that both films hold. A pixel whose coverage differs by more
/// than half a sample of an outline, or whose face differs, is a silhouette flip: counted apart,
/// and left out of the layers. The luminance AOV repeats the colour and is not looked at; patches
/// are told by their parameters. Throws Error when the pictures differ in size.
FilmDifference film_difference(const Film& a, const Film& b, const FilmTolerance& tolerance = {});

} // namespace keiko
