#pragma once

#include "keiko/luminance/visible.h"
#include "keiko/rig/glossy_luminance.h"
#include "keiko/rig/illuminance.h"
#include "keiko/trace/occluders.h"

#include <optional>
#include <vector>

namespace keiko {

/// What an apex sees past the surfaces of a scene, as the luminance core asks for it. Candidates
/// are collected when the first question comes.
class SeenPast final : public Visible {
public:
    /// `region`: corners of a convex body that holds every segment to be asked for. `row`: segments
    /// that are likely to be asked for, best in their order, found together with the first of
    /// them. With `facing` only
    /// what lies before the surface of that normal counts, the rest is hidden. Without occluders
    /// everything is seen; they and the tracer are only looked at. `eye`: see ApexView. Not for two
    /// threads at once.
    SeenPast(const Occluders* occluders, const Tracer& tracer, const Apex& apex,
             std::vector<Vec3> region, std::vector<Segment> row = {},
             const std::optional<Vec3>& facing = {}, const std::optional<Vec3>& eye = {})
        : occluders_(occluders),
          tracer_(tracer),
          apex_(apex),
          region_(std::move(region)),
          row_(std::move(row)),
          facing_(facing),
          eye_(eye) {}

    IntervalSet intervals(const Segment& segment) const override;
    std::vector<IntervalSet> intervals(std::span<const Segment> segments) const override;
    bool seen_alike(std::span<const Segment> segments) const override;

private:
    const ApexView& view() const;
    std::optional<std::size_t> place_in_row(const Segment& segment) const;

    const Occluders* occluders_;
    const Tracer& tracer_;
    Apex apex_;
    std::vector<Vec3> region_;
    std::vector<Segment> row_;
    std::optional<Vec3> facing_, eye_;
    mutable std::optional<ApexView> view_;
    mutable std::vector<IntervalSet> of_row_; ///< once one of the row was asked for
    mutable std::size_t next_ = 0;            ///< after the one of the row that was asked for last
};

class ShadowedRig;

/// A point of a surface or in space under the lights of a rig. What stands between them is found
/// once, for everything that is asked of the point.
class LitPoint {
public:
    /// lx from one source, as illuminance_from.
    Rgb from_source(std::size_t source, TubeModel model, const ClearCoat* coat = nullptr) const;
    /// From all of them, without the rig's ambient light.
    Rgb illuminance(TubeModel model, const ClearCoat* coat = nullptr) const;
    /// cd/m2 that the lobe of a kernel, made for the point's normal, sends to its eye, as
    /// glossy_luminance_from of all sources.
    template <class Kernel>
    Rgb glossy(const Kernel& kernel, GlossQuadrature quadrature = GlossQuadrature::picture) const {
        Rgb sum;
        for (std::size_t i = 0; i < rig_.sources.size(); ++i)
            sum += glossy_luminance_from(rig_.sources[i], rig_.medium, point_, kernel, seen_[i],
                                         quadrature);
        return sum;
    }

private:
    friend class ShadowedRig;
    LitPoint(const ShadowedRig& lights, const Vec3& point, const Vec3& normal,
             const std::optional<Root>& root);

    const LightRig& rig_;
    Vec3 point_, normal_;
    std::vector<SeenPast> seen_; ///< by source
};

/// The sources of a rig as lights that the surfaces of a scene stand in the way of.
class ShadowedRig {
public:
    /// Without occluders nothing casts shadows. All are only looked at.
    ShadowedRig(const LightRig& rig, const Occluders* occluders, const Tracer& tracer)
        : rig_(rig), occluders_(occluders), tracer_(tracer) {}

    /// A point with a unit normal on the side to be lit; of a point on a surface, its own root.
    LitPoint at(const Vec3& point, const Vec3& normal, const std::optional<Root>& root) const {
        return {*this, point, normal, root};
    }

private:
    friend class LitPoint;

    const LightRig& rig_;
    const Occluders* occluders_;
    const Tracer& tracer_;
};

} // namespace keiko
