#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/light/areas/contour_light.h"
#include "keiko/render/shading/lamp_outline.h"
#include "keiko/visibility/contours/body_contour.h"
#include "keiko/visibility/query/occluders.h"

#include <memory>
#include <optional>
#include <vector>

namespace keiko {

/// Luminous body or sheets of exact patches, which alone hide each other.
class TracedLamp final : public LuminousBody {
public:
    /// Body of all faces of a model. Throws Cancelled.
    explicit TracedLamp(SurfaceModel model, const Job& job = {},
                        LampSides sides = LampSides::of_solid);
    TracedLamp(const TracedLamp&) = delete;
    TracedLamp& operator=(const TracedLamp&) = delete;

    const Box3& bounds() const override { return occluders_.tracer().bounds(); }
    std::unique_ptr<Visibility> outline_from(const Vec3& point,
                                             std::vector<Vec3> region) const override;
    std::optional<double> distance(const Vec3& origin, const Vec3& direction) const override;
    bool contains(const Vec3& point) const override;
    Vec3 in_front(const Vec3& point, const Vec3& normal) const override;
    std::shared_ptr<const LuminousBody> moved(const Affine& motion) const override;

    /// True if its outlines are known as arcs, which lamps that are no solid need.
    bool has_known_outlines() const { return contour_.is_known(); }

    /// True if the borders of the body's faces close, and rays find that these point outwards. Rays
    /// aslant to the axes pass several places of each face, and must go in and out by turns. A face
    /// that none meets makes it false. Throws Cancelled.
    bool is_closed(const Job& job = {}) const;

private:
    /// Sides of the sheets that a ray from a point passes, the nearest first; true for outer ones.
    std::vector<bool> sides_along(const Vec3& point, const Vec3& direction) const;

    SurfaceModel model_;
    LampSides sides_;
    Occluders occluders_;
    BodyContour contour_;
};

} // namespace keiko
