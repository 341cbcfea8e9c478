#pragma once

#include "keiko/scene/camera.h"

namespace keiko {

/// The picture of a camera in homogeneous coordinates, affine in space: it holds for places beside
/// and behind the eye too.
class PictureMap {
public:
    /// Copies what it needs of the camera.
    explicit PictureMap(const Camera& camera)
        : axes_(camera.axes()),
          eye_(camera.eye),
          pixel_size_(camera.pixel_size()),
          middle_(Vec2(camera.width / 2.0, camera.height / 2.0) + camera.shift),
          perspective_(camera.projection == Projection::perspective) {}

    /// mm along the middle ray, times the weight of a homogeneous point.
    double depth(const Vec3& point, double weight = 1) const {
        return (point - eye_ * weight).dot(axes_.forward);
    }
    /// (x w, y w, w) of a homogeneous point, x and y in pixels. w is the depth, above 0 before the
    /// eye; of an orthographic camera it is the weight.
    Vec3 at(const Vec3& point, double weight = 1) const {
        const Vec3 offset = (point - eye_ * weight) / pixel_size_;
        const double w = perspective_ ? depth(point, weight) : weight;
        return {middle_.x * w + offset.dot(axes_.right), middle_.y * w - offset.dot(axes_.up), w};
    }

private:
    CameraAxes axes_;
    Vec3 eye_;
    double pixel_size_;
    Vec2 middle_;
    bool perspective_;
};

} // namespace keiko
