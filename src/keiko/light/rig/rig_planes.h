#pragma once

#include "keiko/light/rig/light_rig.h"
#include "keiko/light/tubes/c_plane_lookup.h"
#include "keiko/light/tubes/ray_cone.h"
#include "keiko/math/rgb.h"

#include <limits>
#include <span>
#include <vector>

namespace keiko {

/// Light of a rig along a mirror ray.
struct MirroredLight {
    Rgb luminance;        ///< cd/m2, mean over the pixel; darkness between the lamps
    double coverage = 0;  ///< share of the pixel that lamps fill; the background fills the rest
    bool resolved = true; ///< false: some stripes are too fine and show their mean
    /// Distance to the nearest row that has a lamp in the pixel, in lengths of the direction.
    double t = std::numeric_limits<double>::infinity();
};

/// Intersection of a ray with the nearest C-plane of a rig, inside its rectangle or not.
struct RigPlaneHit {
    std::size_t source = 0;             ///< index into LightRig::sources
    CPlaneHit at;                       ///< place on the plane, and its distance
    const CPlaneFrame* frame = nullptr; ///< of the plane
    std::size_t number = 0;             ///< of the plane among those of the rig
};

/// The C-planes of a rig, prepared for reflected rays. Sources without extent are not visible.
class RigPlanes {
public:
    /// One C-plane of a rig.
    struct Plane {
        std::size_t source; ///< index into LightRig::sources
        CPlaneFrame frame;  ///< of the C-plane, with what its row of lamps measures
        Rgb luminance;      ///< cd/m2, of its lamps
        MirrorModel mirror; ///< of its lamps in reflections
        std::size_t level;  ///< number of the first C-plane of the rig in the same plane: rays meet
                            ///< both at the distance of that one
    };

    /// Planes in the order of the rig's sources; a copy of all that is read of them is kept.
    explicit RigPlanes(const LightRig& rig);

    /// The lamps of every C-plane that the ray meets with t up to `t_max`, in lengths of
    /// `direction`; a lamp behind the next surface is hidden. A nearer row comes before those
    /// behind it, rows at one distance in the order of the rig. With a `spread` each pixel is
    /// integrated in closed form over its footprint on the plane; without one the ray is a point.
    /// The `mirror` of each row selects its model.
    MirroredLight luminance(const Vec3& origin, const Vec3& direction,
                            const std::optional<RayDifferentials>& spread = {},
                            double t_max = std::numeric_limits<double>::infinity()) const;
    /// Luminance along a ray whose nearest plane has been found.
    MirroredLight luminance(const std::optional<RigPlaneHit>& nearest, const Vec3& origin,
                            const Vec3& direction, const std::optional<RayDifferentials>& spread,
                            double t_max) const;
    /// True if luminance() is proved to find no lamp for any ray of a bundle.
    bool are_missed_by(const RayCone& rays) const;
    /// The nearest plane on the ray; for planes at one distance the first of the rig.
    std::optional<RigPlaneHit> nearest(const Vec3& origin, const Vec3& direction) const;
    /// All planes, by their numbers.
    std::span<const Plane> planes() const { return planes_; }

private:
    /// Intersection of a ray with a plane, at the distance of its level.
    std::optional<CPlaneHit> meet(const Plane& plane, const Vec3& origin,
                                  const Vec3& direction) const;
    /// The nearest plane on the ray, or the nearest behind `last`.
    std::optional<RigPlaneHit> next(const Vec3& origin, const Vec3& direction,
                                    const std::optional<RigPlaneHit>& last) const;

    std::vector<Plane> planes_;
};

} // namespace keiko
