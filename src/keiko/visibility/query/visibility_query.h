#pragma once

#include "keiko/geometry/rays/ray.h"
#include "keiko/geometry/rays/visibility.h"
#include "keiko/visibility/query/occluders.h"
#include "keiko/visibility/query/visible_intervals.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace keiko {

class OccluderCandidates;

/// Visibility from one viewpoint: candidates are collected once, for all segments of a region.
/// OccluderCandidates find the events that end visible parts. Not for two threads at once.
class VisibilityQuery {
public:
    /// `region`: corners of a convex body that holds every segment to come. Looks into the
    /// occluders and into `tracer`, which are of one model. With `facing`, a unit normal, only what
    /// lies on its side of the plane through the viewpoint is looked for, the rest counts as
    /// hidden: what a surface is lit from.
    VisibilityQuery(const Occluders& occluders, const Tracer& tracer, const Viewpoint& viewpoint,
                    std::span<const Vec3> region, const std::optional<Vec3>& facing = {});
    ~VisibilityQuery();
    /// Takes over the candidates of another.
    VisibilityQuery(VisibilityQuery&&) noexcept;
    /// Takes over the candidates of another.
    VisibilityQuery& operator=(VisibilityQuery&&) noexcept;

    /// Parts of the segment from a to b such that nothing lies between them and the viewpoint.
    /// Visible parts, and intervals between them, shorter than 1e-9 of the segment are dropped. A
    /// segment without length is seen as a whole or not at all.
    VisibleIntervals intervals(const Segment& segment) const;
    /// Visible parts of several segments. Parallel ones are scan lines of a screen on which every
    /// candidate is placed once, and share rays (docs/theory/visibility.md).
    std::vector<VisibleIntervals> intervals(std::span<const Segment> row) const;

    /// Visibility of whole prisms, all in the region: true where a prism is proved visible, false
    /// where it is proved hidden, nothing where neither is proved. The part of it on the side that
    /// is not faced does not count.
    std::vector<std::optional<bool>> classify_prisms(std::span<const Prism> prisms) const;
    /// Turns of a prism in the region. Some are left out that together make lines `rule.spacing`
    /// apart miss no more than `rule.missed` of the prism, and those of the viewpoint's own patch.
    std::vector<CriticalSlice> turns(const Prism& prism, const TurnRule& rule) const;

private:
    std::unique_ptr<OccluderCandidates> candidates_;
};

} // namespace keiko
