#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/light/areas/contour_light.h"
#include "keiko/visibility/query/occluders.h"

#include <memory>
#include <optional>
#include <vector>

namespace keiko {

/// Luminous body of exact patches, whose contour is that of an occluder that stands alone.
class TracedLamp final : public LuminousBody {
public:
    /// Body of all faces of a model. Throws Cancelled.
    explicit TracedLamp(SurfaceModel model, const Job& job = {});

    const Box3& bounds() const override { return occluders_.tracer().bounds(); }
    std::unique_ptr<Visibility> outline_from(const Vec3& point,
                                             std::vector<Vec3> region) const override;
    std::optional<double> distance(const Vec3& origin, const Vec3& direction) const override;
    bool contains(const Vec3& point) const override;
    Vec3 in_front(const Vec3& point, const Vec3& normal) const override;
    std::shared_ptr<const LuminousBody> moved(const Affine& motion) const override;

    /// True if the borders of the body's faces close, and rays find that these point outwards. Rays
    /// aslant to the axes pass several places of each face, and must go in and out by turns. A face
    /// that none meets makes it false. Throws Cancelled.
    bool is_closed(const Job& job = {}) const;

private:
    SurfaceModel model_;
    Occluders occluders_;
};

} // namespace keiko
