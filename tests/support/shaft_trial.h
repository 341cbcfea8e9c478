#pragma once

#include "keiko/geometry/model/surface_model.h"
#include "keiko/light/rig/light_rig.h"
#include "keiko/scene/camera.h"
#include "keiko/visibility/epipolar/epipolar_shadows.h"
#include "keiko/visibility/query/occluders.h"

#include <span>
#include <vector>

namespace keiko::test {

/// Placement of the steps of marching.
enum class Marching {
    even,        ///< evenly along the ray
    equi_angular ///< evenly in the angle at the lamp [KullaFajardo2012]
};

/// Bodies under sharp spotlights in uniform fog, whose shafts can be had in two ways. Pictures
/// compute them from the parts of a ray that a lamp sees; marching traces a shadow ray each step.
class ShaftTrial {
public:
    /// Lamps in a ring above the model, each aimed at it.
    ShaftTrial(SurfaceModel model, int lamps);

    const Tracer& tracer() const { return tracer_; }
    const Occluders& occluders() const { return occluders_; }
    const LightRig& rig() const { return rig_; }
    /// Rays of `side` x `side` neighbouring pixels of a picture of 960 x 540 that shows the model
    /// from before, a little above its middle: each to where it meets the model or far beyond.
    /// `corner`: upper left, as shares of the picture; at (0.5, 0.5) is the model's middle.
    std::vector<Segment> camera_rays(const Vec2& corner, int side) const;

    /// Epipolar shadows of the lamps, for the eye of those rays.
    std::vector<std::optional<EpipolarShadows>> pencils() const;
    /// Scattered light of each ray, cd/m2, as a picture's tile of all of them has it.
    /// With the pencils of the rays' eye, or at full precision.
    std::vector<Rgb> exact(std::span<const Segment> rays, double tolerance,
                           std::span<const std::optional<EpipolarShadows>> pencils = {}) const;
    /// Scattered light of one ray, cd/m2, by marching `steps` steps in each part of it that lies in
    /// a beam.
    Rgb marched(const Segment& ray, int steps, Marching marching) const;

private:
    Camera camera() const;

    Tracer tracer_;
    Occluders occluders_;
    LightRig rig_;
};

} // namespace keiko::test
