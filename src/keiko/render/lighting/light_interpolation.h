#pragma once

#include "keiko/render/lighting/shading_grid.h"
#include "keiko/render/shading/integrator.h"

namespace keiko {

/// The light of the shading points of a grid, by place: found at places up to eight apart and
/// between them as below. `seen`: what the eye sees of each place besides; `skipped`: places whose
/// light is not asked for, none if empty.
std::vector<DirectLight> light_interpolation(const Integrator& integrator, const ShadingGrid& grid,
                                             std::span<const Rgb> seen,
                                             const std::vector<bool>& skipped, double error);

/// Adds the light of the shading points of a grid of camera rays, `width` in each row, row by row,
/// to their samples, but for those of `skipped` rays. On smooth surfaces it is found at places up
/// to eight pixels apart and between them, and that of each lamp is taken linear or of degree two
/// from one to the next where those between are off by no more than `error` of what the eye sees
/// there, all lamps together, but each mirror reflection by itself; else closer, in the end for
/// each ray. 0: for each ray.
void add_interpolated_light(const Integrator& integrator, int width,
                            const std::vector<bool>& skipped, double error, SampleBatch& view);

} // namespace keiko
