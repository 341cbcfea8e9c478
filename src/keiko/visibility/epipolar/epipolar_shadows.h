#pragma once

#include "keiko/base/job.h"
#include "keiko/math/interval_set.h"
#include "keiko/visibility/query/occluders.h"

#include <memory>
#include <span>
#include <vector>

namespace keiko {

/// What one light sees of rays from one eye. The planes through light and rays all hold the axis
/// from the light to the eye: a pencil of planes. What the light sees edge-on is made curves of,
/// once for all rays of a picture, and sorted by its angle about the axis; a ray asks what its own
/// plane cuts (docs/theory/visibility.md). Immutable after construction; may be asked from any
/// thread.
class EpipolarShadows {
public:
    /// Looks into the occluders and into `tracer`, which are of one model. Light and eye in mm; not
    /// at one place. Throws Cancelled.
    EpipolarShadows(const Occluders& occluders, const Tracer& tracer, const Vec3& light,
                    const Vec3& eye, const Job& job = {});
    ~EpipolarShadows();
    EpipolarShadows(EpipolarShadows&&) noexcept;
    EpipolarShadows& operator=(EpipolarShadows&&) noexcept;

    /// Parts of segments that the light sees, of their parameters: each lies on a ray from the eye
    /// and no surface crosses it. As VisibilityQuery finds them, but for ends, which are told to
    /// outline_error as the light sees them. Neighbours should stand together.
    std::vector<IntervalSet> intervals(std::span<const Segment> segments) const;

private:
    class Planes;
    std::unique_ptr<const Planes> planes_;
};

} // namespace keiko
