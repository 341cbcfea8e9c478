#pragma once

#include "keiko/compare/alignment/surface_samples.h"

#include <span>

namespace keiko {

/// A body as places with normals and the area that each stands for.
using SampleCloud = std::vector<SurfaceSample>;

/// Centre of area.
Vec3 centre_of(const SampleCloud& cloud);

/// The motion of `body` to near `other` from which a search for the best one shall start: the best
/// of where it is, its centre on the other's, and the four turns that lay principal axes on each
/// other, each improved on the clouds. `size` of the other in mm. Throws Cancelled.
Affine coarse_alignment(const SampleCloud& body, const SampleCloud& other, double size,
                        const Job& job = {});

} // namespace keiko
