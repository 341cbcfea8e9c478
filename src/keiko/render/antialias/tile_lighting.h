#pragma once

#include "keiko/render/antialias/subpixels.h"
#include "keiko/render/reflection/sample_batch.h"
#include "keiko/render/shading/integrator.h"

namespace keiko {

/// Adds the light of all shading points of a tile, `width` pixels in a row, to their samples: of
/// the pixels of one ray, `view`, and of the parts of the others. The samples in `view` of pixels
/// in parts are left as they are. The light may deviate by `error` of the visible luminance where
/// it is tested; see light_interpolation(), add_shared_light() and unshadowed_light().
void add_tile_light(const Integrator& integrator, int width, double error, SampleBatch& view,
                    RefinedPixels& refined);

} // namespace keiko
