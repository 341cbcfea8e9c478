#pragma once

#include "keiko/raster/triangle_scan.h"
#include "keiko/scene/camera.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// The space that a camera sees, and the way of corners from there into its picture.
class PictureVolume {
public:
    /// Volume of a camera before `points`, which it is to show.
    PictureVolume(const Camera& camera, std::span<const Vec3> points);

    /// Corner of a point; nullopt for one before the near plane or so far beside the picture that
    /// its subpixels cannot be counted.
    std::optional<ScreenCorner> corner(const Vec3& point) const;
    /// The part of a triangle within the volume, in triangles. It is clipped in space by the near
    /// plane, then in the picture.
    std::vector<ScreenTriangle> clipped(const std::array<Vec3, 3>& triangle) const;

private:
    /// mm along the middle ray.
    double depth(const Vec3& point) const { return (point - eye_).dot(forward_); }
    double nearness(double depth) const { return perspective_ ? 1 / depth : -depth; }
    std::vector<Vec3> images_before_eye(const std::array<Vec3, 3>& triangle) const;

    PreparedCamera camera_;
    Vec3 eye_, forward_;
    bool perspective_;
    double near_ = 0;                    ///< mm, of the near plane
    double left_, top_, right_, bottom_; ///< pixels, within which corners are counted
};

} // namespace keiko
