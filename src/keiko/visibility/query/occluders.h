#pragma once

#include "keiko/base/export.h"
#include "keiko/base/job.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/intersect/traversal/tracer.h"
#include "keiko/math/vec.h"

#include <memory>
#include <optional>
#include <span>

namespace KEIKO_API keiko {

struct OccluderScene;

/// Silhouettes and borders of a model, prepared for visibility queries from many viewpoints. The
/// ends of visible parts are found on the surfaces by Newton's method, to some 1e-12 of the
/// segment, not by sampling rays (docs/theory/visibility.md). Immutable after construction; may be
/// queried from any thread. Copies share what was prepared.
class Occluders {
public:
    /// `tracer` is of the same model. Throws Cancelled.
    Occluders(const SurfaceModel& model, const Tracer& tracer, const Job& job = {});

    /// Tracer of the model.
    const Tracer& tracer() const { return tracer_; }

    /// Size and cost of the preparation.
    struct Statistics {
        std::size_t silhouette_pieces = 0, boundary_pieces = 0; ///< number of each
        double build_seconds = 0;                               ///< wall-clock time
    };
    /// Size and cost of the preparation.
    const Statistics& statistics() const { return statistics_; }

    /// False where all of the hull of `places` is proved to see all of the hull of `region` or
    /// nothing of it, since nothing between can be edge-on. No surface may cross the hull of
    /// `places`. With `facing`, a unit normal, only what lies on its side of all places counts,
    /// beyond rounding, as for the light on a flat surface.
    bool may_occlude(std::span<const Vec3> places, std::span<const Vec3> region,
                     const std::optional<Vec3>& facing = {}) const;

private:
    friend class VisibilityQuery;
    friend class EpipolarShadows;
    std::shared_ptr<const OccluderScene> scene_;
    Tracer tracer_;
    Statistics statistics_;
};

} // namespace keiko
