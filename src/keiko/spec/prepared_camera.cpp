#include "keiko/spec/prepared_camera.h"

namespace keiko {

PreparedCamera::PreparedCamera(const Camera& camera)
    : projection_(camera.projection),
      eye_(camera.eye),
      axes_(camera.axes()),
      middle_(camera.width / 2.0, camera.height / 2.0),
      pixel_size_(camera.pixel_size()),
      dx_(axes_.right * pixel_size_),
      dy_(axes_.up * -pixel_size_) {}

Ray PreparedCamera::ray(double x, double y) const {
    const Vec2 position = Vec2(x - middle_.x, middle_.y - y) * pixel_size_;
    const Vec3 offset = axes_.right * position.x + axes_.up * position.y;
    return projection_ == Projection::orthographic ? parallel_ray(offset) : ray_from_eye(offset);
}

Ray PreparedCamera::parallel_ray(const Vec3& offset) const {
    return {.origin = eye_ + offset,
            .direction = axes_.forward,
            .differentials = RayDifferentials{.origin_dx = dx_, .origin_dy = dy_},
            .excluded = {}};
}

Ray PreparedCamera::ray_from_eye(const Vec3& offset) const {
    const Vec3 through = axes_.forward + offset;
    const double length = through.length();
    const Vec3 direction = through / length;
    const auto of_unit = [&](const Vec3& d) { return (d - direction * direction.dot(d)) / length; };
    return {.origin = eye_,
            .direction = direction,
            .differentials =
                RayDifferentials{.direction_dx = of_unit(dx_), .direction_dy = of_unit(dy_)},
            .excluded = {}};
}

std::optional<Vec2> PreparedCamera::project(const Vec3& point) const {
    const Vec3 offset = point - eye_;
    const double depth = offset.dot(axes_.forward);
    const bool perspective = projection_ == Projection::perspective;
    if (perspective && !(depth > 0)) return {};
    const double scale = pixel_size_ * (perspective ? depth : 1);
    return Vec2(middle_.x + offset.dot(axes_.right) / scale,
                middle_.y - offset.dot(axes_.up) / scale);
}

} // namespace keiko
