#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/geometry/rays/contour_arc.h"

#include <memory>

namespace keiko {

/// The outlines of a model's placed faces from any point, as arcs of conic sections: silhouettes,
/// and borders at which a face ends or turns its back. Around a direction as many sheets turn their
/// outer or their inner side to the point as the arcs wind about it, see ContourArc::left
/// (docs/theory/areas.md#contours-as-arcs). Immutable; may be asked from any thread.
class BodyContour {
public:
    /// Keeps a reference to the model. Throws Cancelled.
    explicit BodyContour(const SurfaceModel& model, const Job& job = {});
    BodyContour(BodyContour&&) noexcept;
    ~BodyContour();

    /// False if a face has a crease inside, along which no outline is known. Patches that join are
    /// compared at a few places of their sides.
    bool is_known() const;
    /// Outlines from a point that is not on the surface. Arcs are halved until their error is at
    /// most `error` times the angle, rad, under which half of the body appears. Two places of each
    /// silhouette test that, and after ten halvings it may be larger. What trim curves leave
    /// of a silhouette between its samples, and a border's side that changes twice between two, may
    /// be missed. The point is moved by some 1e-9 of the body's size, so that it lies in no tangent
    /// plane by design.
    ContourArcs arcs_from(const Vec3& point, double error) const;

private:
    struct Body;
    std::unique_ptr<const Body> body_;
};

} // namespace keiko
