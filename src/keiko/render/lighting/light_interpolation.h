#pragma once

#include "keiko/render/lighting/shading_grid.h"
#include "keiko/render/shading/integrator.h"

namespace keiko {

/// Light of the shading points of a grid, by place, computed at places up to eight apart and
/// interpolated between them as below. `seen`: the visible luminance of each place besides;
/// `skipped`: places whose light is not needed, none if empty.
std::vector<DirectLight> light_interpolation(const Integrator& integrator, const ShadingGrid& grid,
                                             std::span<const Rgb> seen,
                                             const std::vector<bool>& skipped, double error);

/// Adds the light of the shading points of a grid of camera rays, `width` in each row, row by row,
/// to their samples, except those of `skipped` rays. On smooth surfaces it is computed at places up
/// to eight pixels apart. The light of each lamp between them is linear or of degree two. That
/// holds where all lamps together deviate at the places between by at most `error` of the visible
/// luminance there, each mirror reflection by itself. Elsewhere the places are closer, in the end
/// one a ray; 0: one a ray everywhere.
void add_interpolated_light(const Integrator& integrator, int width,
                            const std::vector<bool>& skipped, double error, SampleBatch& view);

} // namespace keiko
