#include "keiko/drawing/curves/image_projection.h"

namespace keiko {

ImageProjection::ImageProjection(const Camera& camera)
    : parallel_(camera.projection == Projection::orthographic),
      eye_(camera.eye),
      axes_(camera.axes()) {}

ImagePoint ImageProjection::image(const Vec3& point) const {
    const Vec3 way = point - eye_;
    const double depth = way.dot(axes_.forward), divisor = parallel_ ? 1 : depth;
    return {Vec2(way.dot(axes_.right), way.dot(axes_.up)) / divisor, depth};
}

Vec3 ImageProjection::sight(const Vec3& point) const {
    return parallel_ ? axes_.forward : (point - eye_).normalized();
}

Ray ImageProjection::sight_line(const Vec3& point, double size) const {
    Ray ray;
    ray.direction = parallel_ ? axes_.forward * size : point - eye_;
    ray.origin = point - ray.direction;
    ray.t_max = 1;
    return ray;
}

Vec2 ImageProjection::image_direction(const Vec3& point, const Vec3& along) const {
    const Vec2 flat(along.dot(axes_.right), along.dot(axes_.up));
    if (parallel_) return flat;
    const ImagePoint from = image(point);
    return (flat - from.at * along.dot(axes_.forward)) / from.depth;
}

double ImageProjection::share_in_space(double in_image, double depth_a, double depth_b) const {
    if (parallel_) return in_image;
    const double near = in_image * depth_a;
    return near / (near + (1 - in_image) * depth_b);
}

} // namespace keiko
