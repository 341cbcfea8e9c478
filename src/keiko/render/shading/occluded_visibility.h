#pragma once

#include "keiko/geometry/visibility/visibility.h"
#include "keiko/visibility/epipolar/epipolar_shadows.h"
#include "keiko/visibility/query/occluders.h"

#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// What a viewpoint sees past the surfaces of a scene, as the luminance core asks for it.
/// Candidates are collected when the first question comes.
class OccludedVisibility final : public Visibility {
public:
    /// `region`: corners of a convex body that holds every segment to be asked for. `row`: segments
    /// that are likely to be asked for, best in their order, found together with the first of
    /// them. With `facing` only what lies before the surface of that normal counts, the rest is
    /// hidden. Without occluders everything is seen; they and the tracer are only looked at.
    /// `pencil`, of the viewpoint as its light: answers for the row in their place. Not for two
    /// threads at once.
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
    mutable std::vector<IntervalSet> of_row_; ///< once one of the row was asked for
    mutable std::size_t next_ = 0;            ///< after the one of the row that was asked for last
};

} // namespace keiko
