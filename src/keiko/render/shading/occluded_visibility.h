#pragma once

#include "keiko/geometry/rays/visibility.h"
#include "keiko/light/rig/luminance_along.h"
#include "keiko/visibility/epipolar/epipolar_shadows.h"
#include "keiko/visibility/query/visibility_query.h"

#include <optional>
#include <span>
#include <vector>

namespace keiko {

// Visibility past the surfaces of a scene, from surface points and along camera rays.

/// Visibility from a viewpoint among the surfaces of a scene, for the luminance computation.
/// Candidates are collected at the first query.
class OccludedVisibility final : public Visibility {
public:
    /// `region`: corners of a convex body that contains every queried segment. `row`: segments that
    /// are likely to be queried, best in their order, found together with the first of them. With
    /// `facing` only the half-space before the surface of that normal counts, the rest is hidden.
    /// Without occluders everything is visible; references to them and the tracer are kept.
    /// `pencil`, with the viewpoint as its light, replaces them for the row. Not for two threads at
    /// once.
    OccludedVisibility(const Occluders* occluders, const Tracer& tracer, const Viewpoint& viewpoint,
                       std::vector<Vec3> region, std::vector<Segment> row = {},
                       const std::optional<Vec3>& facing = {},
                       const EpipolarShadows* pencil = nullptr)
        : occluders_(occluders),
          tracer_(tracer),
          viewpoint_(viewpoint),
          region_(std::move(region)),
          row_(std::move(row)),
          facing_(facing),
          pencil_(pencil) {}

    IntervalSet intervals(const Segment& segment) const override;
    std::vector<IntervalSet> intervals(std::span<const Segment> segments) const override;
    std::vector<std::optional<bool>> classify_prisms(std::span<const Prism> prisms) const override;
    std::vector<CriticalSlice> turns(const Prism& prism, const TurnRule& rule) const override;

private:
    const VisibilityQuery& view() const;
    std::optional<std::size_t> place_in_row(const Segment& segment) const;

    const Occluders* occluders_;
    const Tracer& tracer_;
    Viewpoint viewpoint_;
    std::vector<Vec3> region_;
    std::vector<Segment> row_;
    std::optional<Vec3> facing_;
    const EpipolarShadows* pencil_;
    mutable std::optional<VisibilityQuery> view_;
    mutable std::vector<IntervalSet> of_row_; ///< after the first query of the row
    mutable std::size_t next_ = 0;            ///< after the last queried one of the row
};

/// Pencils of the point lights of a rig for the rays of a picture from one viewpoint, by source;
/// empty if nothing casts shadows in a medium. Throws Cancelled.
std::vector<std::optional<EpipolarShadows>> shaft_pencils(const LightRig& rig,
                                                          const Occluders* occluders,
                                                          const Tracer& tracer, const Vec3& eye,
                                                          const Job& job = {});

/// Visibility of camera rays from the lights of a rig past the surfaces of a scene: the lit parts
/// of their shafts in the medium. Possible occluders of a light are found once for all of the rays.
class VolumetricShadows {
public:
    /// `camera_rays` contain every segment to come; neighbouring ones should be adjacent. Without
    /// occluders, or without a medium, no shadows are cast. `pencils` are those of shaft_pencils,
    /// for the viewpoint of all of the rays, each ray up to the first surface; empty for any other
    /// rays. References are kept to everything except the rays. Not for two threads at once.
    VolumetricShadows(const LightRig& rig, const Occluders* occluders, const Tracer& tracer,
                      std::span<const Segment> camera_rays,
                      std::span<const std::optional<EpipolarShadows>> pencils = {});

    /// Visibility function for luminance_along; refers to this object.
    VisibleFrom visible() const;

private:
    std::vector<OccludedVisibility> seen_; ///< by source; empty if nothing casts shadows
};

} // namespace keiko
