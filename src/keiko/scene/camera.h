#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/rays/ray.h"
#include "keiko/math/bounds.h"

#include <optional>
#include <span>
#include <vector>

namespace KEIKO_API keiko {

/// Projection of a camera.
enum class Projection {
    perspective, ///< from a point
    orthographic ///< along one direction
};

/// Unit axes of a picture in space; right x up = -forward.
struct CameraAxes {
    Vec3 right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, -1}; ///< in the world
};

/// The eye of a picture. Lengths in mm, angles in degrees, pixel (0, 0) at the upper left.
struct Camera {
    Projection projection = Projection::perspective; ///< perspective unless stated
    Vec3 eye{3000, -2500, 1400};    ///< mm; of an orthographic camera, a point on the middle ray
    Vec3 target{0, 0, 600};         ///< mm; a point on the middle ray
    Vec3 up{0, 0, 1};               ///< direction that is upwards in the picture
    double vertical_fov = 28;       ///< degrees; perspective only
    double orthographic_height = 0; ///< mm across the picture's height; orthographic only
    int width = 960, height = 540;  ///< pixels
    Vec2 shift{0}; ///< pixels by which the middle ray stands right of the middle, and below it

    /// Ray with unit direction through the picture point (x, y) in pixels, (0.5, 0.5) being the
    /// centre of the upper left pixel; with differentials per pixel. For many rays: PreparedCamera.
    Ray ray(double x, double y) const;
    /// Solid angle of the pixel at (x, y) in sr; for orthographic cameras the same for all: 1.
    double pixel_solid_angle(double x, double y) const;
    /// The axes of the picture. Where `up` is along the view direction, another axis of space
    /// takes its place.
    CameraAxes axes() const;
    /// Edge of a pixel: mm for orthographic cameras, else a length on the picture plane at
    /// distance 1 from the eye.
    double pixel_size() const;

    bool operator==(const Camera&) const = default;
};

/// Picture position in pixels of a point in space, inside the picture or not; nothing for points
/// beside or behind the eye of a perspective camera.
std::optional<Vec2> project(const Camera& camera, const Vec3& point);

/// A camera made ready for many rays and points: what they have in common is found once.
class PreparedCamera {
public:
    /// Prepares a camera; keeps no reference.
    explicit PreparedCamera(const Camera& camera);

    /// Camera::ray.
    Ray ray(double x, double y) const;
    /// Rays of many points as ray() has them, several computed side by side.
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
    Vec2 middle_;       ///< where the middle ray meets the picture, in pixels
    double pixel_size_; ///< Camera::pixel_size
    Vec3 dx_, dy_;      ///< of a pixel on the picture plane
};

} // namespace keiko
