#pragma once

#include "keiko/geometry/rays/visibility.h"
#include "keiko/visibility/query/visibility_query.h"

#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// Visibility from one point of an element among occluders. Not for two threads at once.
class PointVisibility final : public Visibility {
public:
    /// `region`: corners of a convex body that holds all segments to come. Only what lies before
    /// the element, on the side of its unit normal, counts.
    PointVisibility(const Occluders& occluders, const Vec3& point, const Vec3& normal,
                    std::span<const Vec3> region)
        : query_(occluders, occluders.tracer(), Viewpoint::at(point), region, normal) {}

    IntervalSet intervals(const Segment& segment) const override {
        return query_.intervals(segment).intervals;
    }
    std::vector<IntervalSet> intervals(std::span<const Segment> segments) const override {
        std::vector<IntervalSet> seen;
        for (VisibleIntervals& parts : query_.intervals(segments))
            seen.push_back(std::move(parts.intervals));
        return seen;
    }
    std::vector<std::optional<bool>> classify_prisms(std::span<const Prism> prisms) const override {
        return query_.classify_prisms(prisms);
    }
    std::vector<CriticalSlice> turns(const Prism& prism, const TurnRule& rule) const override {
        return query_.turns(prism, rule);
    }

private:
    VisibilityQuery query_;
};

} // namespace keiko
