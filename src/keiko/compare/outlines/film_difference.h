#pragma once

#include "keiko/base/export.h"
#include "keiko/film/film.h"
#include "keiko/scene/fixture_spec.h"

#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// One layer of two pictures where both show the same surface.
struct LayerDifference {
    std::string layer;           ///< "color", or the name of an AOV
    std::size_t beyond = 0;      ///< pixels farther apart than the tolerance
    double largest = 0;          ///< in the layer's unit; infinity where one is no number
    double excess = 0;           ///< the largest, in tolerances
    double root_mean_square = 0; ///< over the compared pixels
    int x = 0, y = 0;            ///< pixel of the largest excess, the first of equals
    bool within = true;          ///< no more pixels beyond the tolerance than are allowed
};

/// How far apart two pictures are.
struct FilmDifference {
    std::size_t pixels = 0, compared = 0; ///< in all, and those that the layers are compared in
    std::size_t coverage_flips = 0;       ///< pixels in which the outline moved
    std::size_t face_flips = 0;           ///< others whose centre shows another face
    bool flips_within = true;             ///< no more of them than are allowed
    std::vector<LayerDifference> layers;  ///< the colour, then the AOVs that both films hold
    Image excess; ///< 1 channel: the largest excess of any layer, infinity in flipped pixels

    /// True if the flips and all layers are within the tolerances.
    bool within() const;
};

/// Compares the colour and the AOVs that both films hold. A pixel whose coverage differs by more
/// than half a sample of an outline, or whose face differs, is a silhouette flip: counted apart,
/// and left out of the layers. The luminance AOV repeats the colour and is not compared; patches
/// are distinguished by their parameters. Pixels where `left_out`, of one channel, is not 0 are no
/// flips and in no layer. Throws Error when the pictures differ in size.
FilmDifference film_difference(const Film& a, const Film& b, const FilmTolerance& tolerance = {},
                               const Image* left_out = nullptr);

} // namespace keiko
