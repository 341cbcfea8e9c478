#pragma once

#include "keiko/base/export.h"
#include "keiko/base/job.h"
#include "keiko/geometry/visibility/ray.h"
#include "keiko/geometry/visibility/visibility.h"
#include "keiko/intersect/traversal/tracer.h"
#include "keiko/math/interval_set.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace KEIKO_API keiko {

/// Visible parts of a segment from one viewpoint.
struct VisibleIntervals {
    IntervalSet intervals; ///< of the segment's parameter, 0 at its begin, 1 at its end
    /// False where events could not be separated: an end may be wrong, or a narrow part missing
    /// there.
    bool certain = true;
};

class VisibilityQuery;

/// Silhouettes and borders of a model, prepared for visibility queries from many viewpoints. The
/// ends of visible parts are found on the surfaces by Newton's method, to some 1e-12 of the
/// segment, not by sampling rays (docs/theory/visibility.md). Immutable after construction; may be
/// queried from any thread.
class Occluders {
public:
    /// `tracer` is of the same model, and not kept. Throws Cancelled.
    Occluders(const SurfaceModel& model, const Tracer& tracer, const Job& job = {});
    ~Occluders();
    /// Takes over the silhouettes of another.
    Occluders(Occluders&&) noexcept;
    Occluders& operator=(Occluders&&) noexcept; ///< Takes over the silhouettes of another.

    /// Size and cost of the preparation.
    struct Statistics {
        std::size_t silhouette_pieces = 0, boundary_pieces = 0; ///< number of each
        double build_seconds = 0;                               ///< wall-clock time
    };
    /// Size and cost of the preparation.
    const Statistics& statistics() const;

    /// False where all of the hull of `places` is proved to see all of the hull of `region` or
    /// nothing of it, since nothing between can be edge-on. No surface may cross the hull of
    /// `places`. With `facing`, a unit normal, only what lies on its side of all places counts,
    /// beyond rounding, as for the light on a flat surface.
    bool may_occlude(std::span<const Vec3> places, std::span<const Vec3> region,
                     const std::optional<Vec3>& facing = {}) const;

private:
    friend class VisibilityQuery;
    friend class EpipolarShadows;
    struct Scene;
    std::unique_ptr<Scene> scene_;
};

/// Visibility from one viewpoint: candidates are collected once, for all segments of a region.
/// Candidates in visibility_query.h finds the events that end visible parts. Not for two threads at
/// once.
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
    class Candidates;
    std::unique_ptr<Candidates> candidates_;
};

} // namespace keiko
