#pragma once

#include "keiko/light/rig/prepared_rig.h"
#include "keiko/texels/scene_texels.h"
#include "keiko/volumes/scene_volumes.h"

namespace keiko {

/// Loss of the light of lamps in the volumes and texels of a scene, along straight ways
/// (docs/theory/volumes.md#shadows).
class MatterLoss {
public:
    /// Null: without. Keeps references to both.
    MatterLoss(const SceneVolumes* volumes, const SceneTexels* texels)
        : volumes_(volumes), texels_(texels) {}

    /// False where there are neither.
    bool any() const { return volumes_ || texels_; }
    /// Share, 0 to 1, of the light of a lamp of a source that reaches a point: the mean over its
    /// lamp_places().
    double left(const PreparedSource& source, int lamp, const Vec3& point) const;
    /// Share of light that passes a segment.
    double passed(const Segment& way) const;

private:
    const SceneVolumes* volumes_;
    const SceneTexels* texels_;
};

} // namespace keiko
