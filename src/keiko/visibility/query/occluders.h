#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/visibility/viewpoint.h"
#include "keiko/geometry/visibility/visibility.h"
#include "keiko/intersect/traversal/tracer.h"
#include "keiko/math/interval_set.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// What a viewpoint sees of a segment.
struct VisibleIntervals {
    IntervalSet intervals; ///< of the segment's parameter, 0 at its begin, 1 at its end
    /// False when somewhere events could not be told apart: an end may be off, or a narrow part
    /// missing there.
    bool certain = true;
};

class VisibilityQuery;

/// All that may hide something in a model, made ready to be asked from many viewpoints which parts
/// of segments they see past it: the ends of those parts are silhouettes and borders found on the
/// surfaces by Newton's method to some 1e-12 of the segment, not by sampling rays
/// (docs/theory/visibility.md). Immutable after construction; may be asked from any thread.
class Occluders {
public:
    /// `tracer` is of the same model, and not kept. Throws Cancelled.
    Occluders(const SurfaceModel& model, const Tracer& tracer, const Job& job = {});
    ~Occluders();
    Occluders(Occluders&&) noexcept;
    Occluders& operator=(Occluders&&) noexcept;

    struct Statistics {
        std::size_t silhouette_pieces = 0, boundary_pieces = 0;
        double build_seconds = 0;
    };
    const Statistics& statistics() const;

    /// False where it is proved that all of the hull of `places`, which no surface crosses, sees
    /// all of the hull of `region` or nothing of it: what any of them may see edge-on is not
    /// between. With `facing`, a unit normal, only what lies on its side of all places counts,
    /// beyond rounding: what a flat surface is lit from.
    bool may_occlude(std::span<const Vec3> places, std::span<const Vec3> region,
                     const std::optional<Vec3>& facing = {}) const;

private:
    friend class VisibilityQuery;
    friend class EpipolarShadows;
    struct Scene;
    std::unique_ptr<Scene> scene_;
};

/// What one viewpoint may ask: candidates are collected once, for all segments of a region. Not for
/// two threads at once.
class VisibilityQuery {
public:
    /// `region`: corners of a convex body that holds every segment to come. Looks into the
    /// occluders and into `tracer`, which are of one model. With `facing`, a unit normal, only what
    /// lies on its side of the plane through the viewpoint is looked for, the rest counts as
    /// hidden: what a surface is lit from.
    VisibilityQuery(const Occluders& occluders, const Tracer& tracer, const Viewpoint& viewpoint,
                    std::span<const Vec3> region, const std::optional<Vec3>& facing = {});
    ~VisibilityQuery();
    VisibilityQuery(VisibilityQuery&&) noexcept;
    VisibilityQuery& operator=(VisibilityQuery&&) noexcept;

    /// Parts of the segment from a to b such that nothing lies between them and the viewpoint.
    /// Parts and gaps shorter than 1e-9 of the segment are dropped. A segment without length is
    /// seen as a whole or not at all.
    VisibleIntervals intervals(const Segment& segment) const;
    /// The same of several segments. Parallel ones are scan lines of a screen on which every
    /// candidate is placed once, and share rays (docs/theory/visibility.md).
    std::vector<VisibleIntervals> intervals(std::span<const Segment> row) const;

    /// Of each prism, all in the region, true where it is proved to be seen as a whole, false where
    /// nothing of it is, in both cases but for what of it lies on the side that is not faced;
    /// nothing where neither is proved.
    std::vector<std::optional<bool>> classify_prisms(std::span<const Prism> prisms) const;
    /// Turns of a prism in the region. `gap`: between the lines that are looked at, of its width.
    /// Some are left out that together make those miss no more than `missed` of the prism, and
    /// those of the viewpoint's own patch.
    std::vector<CriticalSlice> turns(const Prism& prism, const TurnRule& rule) const;

private:
    class Candidates;
    std::unique_ptr<Candidates> candidates_;
};

} // namespace keiko
