#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/rays/ray.h"
#include "keiko/scene/camera.h"

namespace KEIKO_API keiko {

/// A point of a drawing's image plane, and its depth.
struct ImagePoint {
    Vec2 at{0};       ///< right and up: mm if parallel, else lengths at distance 1 from the eye
    double depth = 0; ///< mm, forward of the eye
};

/// Projection of a body onto the image plane of a camera, in the units of space and not of pixels.
/// A point X has x = (X - E).right / depth and y = (X - E).up / depth. Parallel projection does not
/// divide.
class ImageProjection {
public:
    /// Projection of a camera; its size in pixels is not read.
    explicit ImageProjection(const Camera& camera);

    /// True for parallel lines of sight.
    bool parallel() const { return parallel_; }
    /// Axes of the image.
    const CameraAxes& axes() const { return axes_; }
    /// Image of a point, which must lie before the eye of a perspective projection.
    ImagePoint image(const Vec3& point) const;
    /// Unit direction of the line of sight that ends at a point, from the eye.
    Vec3 sight(const Vec3& point) const;
    /// The line of sight from before a body of the given size to a point, which is at t_max = 1.
    /// `size`: mm, at least the extent of the body along the line; of parallel sight only.
    Ray sight_line(const Vec3& point, double size) const;
    /// Derivative of the image at a point along a vector of space.
    Vec2 image_direction(const Vec3& point, const Vec3& along) const;
    /// Share of a segment's length in space at a share of the length of its image. Depths are those
    /// of both ends.
    double share_in_space(double in_image, double depth_a, double depth_b) const;

private:
    bool parallel_;
    Vec3 eye_;
    CameraAxes axes_;
};

} // namespace keiko
