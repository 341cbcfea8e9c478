#pragma once

#include "keiko/render/lighting/shading_grid.h"
#include "keiko/render/shading/integrator.h"

#include <span>
#include <vector>

namespace keiko {

/// A shading point to be lit, in a tile.
struct LitPlace {
    Pixel pixel;               ///< of the tile
    const ShadingPoint* point; ///< not null
    Rgb seen;                  ///< luminance of its sample besides
};

/// Light of places in a tile, by place, where Integrator::light_is_smooth(). All are of one branch.
/// Neighbours of one paint whose normals lie within 60 degrees form regions. The light of a region
/// is a polynomial of position and normal, fitted to the light at a few of the places. Each of
/// those deviates from what the others predict by at most `error` of the visible luminance there.
/// Where one deviates by more, the halves of the region are fitted. Places to which a fit would
/// extrapolate, or whose normals deviate from a fit of the normals, form a region of their own. 0:
/// the light of each place is computed.
std::vector<DirectLight> unshadowed_light(const Integrator& integrator,
                                          std::span<const LitPlace> places, double error);

} // namespace keiko
