#pragma once

#include "keiko/drawing/curves/image_projection.h"
#include "keiko/drawing/curves/model_curve.h"
#include "keiko/intersect/traversal/tracer.h"

namespace keiko {

/// Counts by rays what hides points of curves. A point that lies in a surface to within a millionth
/// of the body's size is not hidden by it. Keeps references to its arguments.
class SightTest {
public:
    /// `tracer`: of the body.
    SightTest(const Tracer& tracer, const ImageProjection& projection);

    /// Number of sheets of the surface between the eye and a point of a curve.
    int sheets_before(const Vec3& point, const ModelCurve& curve) const;
    /// True if nothing is between the eye and a point of a curve.
    bool visible(const Vec3& point, const ModelCurve& curve) const;
    /// The view.
    const ImageProjection& projection() const { return projection_; }
    /// Size of the body, mm.
    double size() const { return size_; }

private:
    /// True if a hit of the line of sight hides the point at its end, at t = 1.
    bool hides(const Hit& hit, const Ray& ray, const ModelCurve& curve) const;

    const Tracer& tracer_;
    const ImageProjection& projection_;
    double size_;
    double before_; ///< mm, length of parallel lines of sight
};

} // namespace keiko
