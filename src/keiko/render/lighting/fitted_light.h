#pragma once

#include "keiko/render/lighting/lit_regions.h"
#include "keiko/render/shading/integrator.h"

#include <span>
#include <vector>

namespace keiko {

/// Light of some lights of Integrator::smooth_lights() at places in a tile, by place. All places
/// are of one branch; the lights are lamps without shadows, or those of open skies alone. Places of
/// a region are neighbours of one paint whose normals lie within 60 degrees, below a sky and under
/// lobes of one smooth surface. The light of a region is a polynomial of position and normal,
/// fitted to the light at a few of the places. Each of those deviates from what the others predict
/// by at most `error` of the visible luminance there. Below a sky three times `error` of the light
/// that it would bring past no body is allowed besides. Where one deviates by more, the halves of
/// the region are fitted. There are 12 or 18 such places a region, which is a tile of 64 pixels at
/// most: narrower shadows may be missed. Below a sky they are looked for beside other surfaces, at
/// a place in each eight pixels. Places to which a fit would extrapolate, or whose normals deviate
/// from a fit of the normals, form a region of their own. 0: the light of each place is computed.
std::vector<DirectLight> fitted_light(const Integrator& integrator, std::span<const LightId> lights,
                                      std::span<const LitPlace> places, double error);

} // namespace keiko
