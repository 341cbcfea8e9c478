#pragma once

#include "keiko/geometry/model/surface_model.h"
#include "keiko/import/subdivision/cage.h"

#include <string>

namespace keiko::test {

/// The largest differences between a model and an oracle of OpenSubdiv's.
struct Deviation {
    double position = 0; ///< share of the cage's size
    double normal = 0;   ///< radians
    std::size_t points = 0, normals = 0, missed = 0;

    std::string text() const;
};

/// Patches of the model against the limit masks (Far::PrimvarRefiner::Limit) of the vertices of
/// the uniformly refined cage, as all patches see them that touch such a vertex. Normals where
/// the vertex follows the smooth rule. Catmull-Clark only: by face parameters.
Deviation from_limit_masks(const subdivision::Cage& cage, const SurfaceModel& model, int level);

/// Deviation from the limit masks at smooth vertices, where rays along the limit normal meet the
/// traced model.
Deviation rays_from_limit_masks(const subdivision::Cage& cage, const SurfaceModel& model,
                                int level);

/// Against Bfr with approximation levels of 10 at places inside the faces, `steps` along each
/// parameter, by face parameters. Catmull-Clark only.
Deviation from_bfr(const subdivision::Cage& cage, const SurfaceModel& model, int steps);

/// Deviation from Bfr by rays, for any scheme.
Deviation rays_from_bfr(const subdivision::Cage& cage, const SurfaceModel& model, int steps);

} // namespace keiko::test
