#pragma once

#include "keiko/scene/camera.h"

#include <span>
#include <vector>

namespace keiko {

/// A camera made ready for many rays and points: what they have in common is found once.
class PreparedCamera {
public:
    explicit PreparedCamera(const Camera& camera);

    /// Camera::ray.
    Ray ray(double x, double y) const;
    /// The same of many points, several side by side.
    Rays rays(std::span<const Vec2> points) const;
    /// project() of the camera.
    std::optional<Vec2> project(const Vec3& point) const;

private:
    Ray parallel_ray(const Vec3& offset) const;
    Ray ray_from_eye(const Vec3& offset) const;
    /// ray_from_eye() of up to `side_by_side` points.
    void put_rays_from_eye(std::span<const Vec2> points, std::span<Ray> rays) const;

    static constexpr std::size_t side_by_side = 8;

    Projection projection_;
    Vec3 eye_;
    CameraAxes axes_;
    Vec2 middle_;       ///< of the picture, in pixels
    double pixel_size_; ///< Camera::pixel_size
    Vec3 dx_, dy_;      ///< of a pixel on the picture plane
};

} // namespace keiko
