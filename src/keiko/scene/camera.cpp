#include "keiko/scene/camera.h"

#include "keiko/base/units.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keiko {
namespace {

/// Sine of the angle to the view direction below which `up` says nothing.
constexpr double parallel = 1e-9;

/// The place in pixels at which the middle ray meets the picture.
Vec2 middle_of(const Camera& camera) {
    return Vec2(camera.width / 2.0, camera.height / 2.0) + camera.shift;
}

/// Position on the picture plane, in its own unit (see Camera::pixel_size), right and up.
Vec2 plane_position(const Camera& camera, double x, double y) {
    const Vec2 middle = middle_of(camera);
    return Vec2(x - middle.x, middle.y - y) * camera.pixel_size();
}

} // namespace

CameraAxes Camera::axes() const {
    const Vec3 forward = (target - eye).normalized();
    Vec3 right;
    for (const Vec3& candidate : {up.normalized(), Vec3(0, 0, 1), Vec3(0, 1, 0)}) {
        right = forward.cross(candidate);
        if (right.length() > parallel) break;
    }
    right.normalize();
    return {right, right.cross(forward), forward};
}

double Camera::pixel_size() const {
    const double plane_height = projection == Projection::orthographic
                                    ? orthographic_height
                                    : 2 * std::tan(degrees_to_radians(vertical_fov) / 2);
    return plane_height / height;
}

Ray Camera::ray(double x, double y) const {
    return PreparedCamera(*this).ray(x, y);
}

double Camera::pixel_solid_angle(double x, double y) const {
    if (projection == Projection::orthographic) return 1;
    const double squared = 1 + plane_position(*this, x, y).length2();
    return pixel_size() * pixel_size() / (squared * std::sqrt(squared));
}

std::optional<Vec2> project(const Camera& camera, const Vec3& point) {
    return PreparedCamera(camera).project(point);
}

namespace {

template <std::size_t n>
using Lanes = std::array<double, n>;
/// The coordinates of vectors side by side.
template <std::size_t n>
using Vectors = std::array<Lanes<n>, 3>;

template <std::size_t n>
Vec3 at(const Vectors<n>& vectors, std::size_t i) {
    return {vectors[0][i], vectors[1][i], vectors[2][i]};
}

/// How unit directions change where the vectors they are of change by d; `per_length`: one over
/// those vectors' lengths.
template <std::size_t n>
Vectors<n> changes(const Vectors<n>& direction, const Lanes<n>& per_length, const Vec3& d) {
    Vectors<n> change;
    for (std::size_t i = 0; i < n; ++i) {
        const double along = direction[0][i] * d.x + direction[1][i] * d.y + direction[2][i] * d.z;
        for (unsigned k = 0; k < 3; ++k)
            change[k][i] = (d[k] - direction[k][i] * along) * per_length[i];
    }
    return change;
}

} // namespace

PreparedCamera::PreparedCamera(const Camera& camera)
    : projection_(camera.projection),
      eye_(camera.eye),
      axes_(camera.axes()),
      middle_(middle_of(camera)),
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
    const double per_length = 1 / through.length(); // of at least 1
    const Vec3 direction = through * per_length;
    const auto of_unit = [&](const Vec3& d) {
        return (d - direction * direction.dot(d)) * per_length;
    };
    return {.origin = eye_,
            .direction = direction,
            .differentials =
                RayDifferentials{.direction_dx = of_unit(dx_), .direction_dy = of_unit(dy_)},
            .excluded = {}};
}

Rays PreparedCamera::rays(std::span<const Vec2> points) const {
    Rays rays(points.size());
    if (projection_ == Projection::orthographic) {
        for (std::size_t i = 0; i < points.size(); ++i) rays[i] = ray(points[i].x, points[i].y);
        return rays;
    }
    for (std::size_t first = 0; first < points.size(); first += side_by_side) {
        const std::size_t count = std::min(side_by_side, points.size() - first);
        put_rays_from_eye(points.subspan(first, count), std::span(rays).subspan(first, count));
    }
    return rays;
}

void PreparedCamera::put_rays_from_eye(std::span<const Vec2> points, std::span<Ray> rays) const {
    Lanes<side_by_side> x{}, y{}, per_length;
    for (std::size_t i = 0; i < points.size(); ++i) x[i] = points[i].x, y[i] = points[i].y;
    Vectors<side_by_side> direction;
    for (std::size_t i = 0; i < side_by_side; ++i) {
        const double right = (x[i] - middle_.x) * pixel_size_;
        const double up = (middle_.y - y[i]) * pixel_size_;
        const Vec3 through = axes_.forward + (axes_.right * right + axes_.up * up);
        per_length[i] = 1 / std::sqrt(through.length2());
        for (unsigned k = 0; k < 3; ++k) direction[k][i] = through[k] * per_length[i];
    }
    const auto dx = changes(direction, per_length, dx_), dy = changes(direction, per_length, dy_);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        rays[i].origin = eye_;
        rays[i].direction = at(direction, i);
        RayDifferentials& d = rays[i].differentials.emplace();
        d.direction_dx = at(dx, i), d.direction_dy = at(dy, i);
    }
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
