#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/rays/visibility.h"
#include "keiko/math/interval_set.h"
#include "keiko/visibility/query/occluders.h"

#include <memory>
#include <span>
#include <vector>

namespace keiko {

/// Visibility of rays from one eye for one light. The planes through light and rays all hold the
/// axis from the light to the eye: a pencil of planes. Curves are made once of all that the light
/// sees edge-on, for all rays of a picture, and sorted by angle about the axis. A ray then tests
/// the curves that its own plane cuts (docs/theory/visibility.md). Immutable after construction;
/// may be queried from any thread.
class EpipolarShadows {
public:
    /// Looks into the occluders and into `tracer`, which are of one model. Light and eye in mm; not
    /// at one place. Throws Cancelled.
    EpipolarShadows(const Occluders& occluders, const Tracer& tracer, const Vec3& light,
                    const Vec3& eye, const Job& job = {});
    ~EpipolarShadows();
    /// Takes over the curves of another.
    EpipolarShadows(EpipolarShadows&&) noexcept;
    EpipolarShadows& operator=(EpipolarShadows&&) noexcept; ///< Takes over the curves of another.

    /// Visible parts of segments, as parameters: each segment lies on a ray from the eye and no
    /// surface crosses it. Equal to those of VisibilityQuery, except that ends are accurate to
    /// outline_error as the light sees them. Neighbours should stand together.
    std::vector<IntervalSet> intervals(std::span<const Segment> segments) const;

private:
    class Planes;
    std::unique_ptr<const Planes> planes_;
};

} // namespace keiko
