#pragma once

#include "keiko/drawing/curves/image_projection.h"
#include "keiko/drawing/curves/model_curve.h"
#include "keiko/intersect/traversal/tracer.h"

#include <span>
#include <vector>

namespace keiko {

/// Visibility of a point of a curve.
struct PointSight {
    bool visible = true; ///< nothing is between the eye and the point
    bool sure = true;    ///< false where a surface is only just too near to hide a visible point
    bool by_own = false; ///< hidden by a face of the curve itself, as behind its outline
};

/// Counts by rays what hides points of curves. A surface hides a point if it lies before it by more
/// than 1e-6 of the body's size along the line of sight. Square to the surface it must be more than
/// 1e-8 of the size, or 1e-11 on a face of the curve. Both grow by the curve's reach. At a seam the
/// latter grows by 1e-6 of the size and twice the seam's width. Keeps references to its arguments.
class SightTest {
public:
    /// `tracer`: of the body.
    SightTest(const SurfaceModel& model, const Tracer& tracer, const ImageProjection& projection);

    /// Number of sheets of the surface between the eye and a point of a curve.
    int sheets_before(const Vec3& point, const ModelCurve& curve) const;
    /// True if nothing is between the eye and a point of a curve.
    bool visible(const Vec3& point, const ModelCurve& curve) const;
    /// visible() of many points of one curve, in order, and whether it is sure.
    std::vector<PointSight> sights(std::span<const Vec3> points, const ModelCurve& curve) const;
    /// True if nothing is between the eye and a place a millionth of the body's size beside a point
    /// of a curve in the image: edges that coincide there hide each other by rounding alone.
    bool visible_beside(const Vec3& point, const ModelCurve& curve) const;
    /// The view.
    const ImageProjection& projection() const { return projection_; }
    /// Size of the body, mm.
    double size() const { return size_; }

private:
    /// True if a hit of the line of sight hides the point at its end, at t = 1.
    bool hides(const Hit& hit, const Ray& ray, const ModelCurve& curve) const;

    static bool is_own(const Hit& hit, const ModelCurve& curve);
    /// Width of the seam at which a hit was found, world, mm, at most.
    double seam_width(const Hit& hit) const;

    const Tracer& tracer_;
    const ImageProjection& projection_;
    double size_;
    double before_;                   ///< mm, length of parallel lines of sight
    std::vector<double> seam_widths_; ///< mm, part coordinates, by edge of the file
    std::vector<double> stretches_;   ///< by instance: of lengths at most
};

} // namespace keiko
