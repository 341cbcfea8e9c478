#pragma once

#include "keiko/render/antialias/edge_cell.h"
#include "keiko/render/antialias/subpixels.h"
#include "keiko/render/shading/integrator.h"
#include "keiko/scene/camera.h"

namespace keiko {

/// Divides `pixels`, adaptively. Cells whose corners and centre see one smooth thing stay whole;
/// those that one straight edge crosses are split along it, where it is found by halving. Others
/// are halved across the largest variation, down to sides of `finest`, px. They are quartered if
/// their centre alone shows something, which may halve a side of `finest` once more. Cells of one
/// surface whose image on the lamps' plane is bent are cut into strips. Pixels that turn out to be
/// whole and have a `centre` are left out of the result.
RefinedPixels refined_pixels(const Integrator& integrator, const PreparedCamera& camera,
                             std::vector<EdgeCell> pixels, double finest);

} // namespace keiko
