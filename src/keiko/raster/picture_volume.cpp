#include "keiko/raster/picture_volume.h"

#include "keiko/math/convex_clip.h"

#include <algorithm>

namespace keiko {
namespace {

/// Pixels beside the picture that corners may have. With pictures of 16384 pixels a side, products
/// of two extents in subpixels stay below 2^48.
constexpr double guard = 16384;
/// Depth of the near plane as a share of that of the farthest point: 1/z then spans as many digits,
/// of the 16 that a double has.
constexpr double nearest_share = 1e-6;

std::int32_t to_subpixels(double pixels) {
    // Above 0, where a cast rounds down: no call of a function, for millions of corners.
    constexpr auto offset = std::int64_t{1} << 40;
    const double scaled = pixels * static_cast<double>(subpixels) + 0.5;
    return static_cast<std::int32_t>(
        static_cast<std::int64_t>(scaled + static_cast<double>(offset)) - offset);
}

ScreenCorner corner_at(double x, double y, double nearness) {
    return {to_subpixels(x), to_subpixels(y), nearness};
}

/// The part of a polygon where a linear function is not negative.
template <class Value>
std::vector<Vec3> clipped_by(const std::vector<Vec3>& polygon, const Value& value) {
    std::vector<Vec3> part;
    clip_convex(
        polygon, [&](std::size_t i) { return value(polygon[i]); },
        [&](const Vec3& corner) { part.push_back(corner); });
    return part;
}

} // namespace

PictureVolume::PictureVolume(const Camera& camera, std::span<const Vec3> points)
    : camera_(camera),
      eye_(camera.eye),
      forward_(camera.axes().forward),
      perspective_(camera.projection == Projection::perspective),
      left_(-guard),
      top_(-guard),
      right_(camera.width + guard),
      bottom_(camera.height + guard) {
    double farthest = 0;
    for (const Vec3& point : points) farthest = std::max(farthest, depth(point));
    if (perspective_) near_ = nearest_share * farthest;
}

std::optional<ScreenCorner> PictureVolume::corner(const Vec3& point) const {
    const double deep = depth(point);
    if (!(deep >= near_)) return std::nullopt;
    const auto at = camera_.project(point);
    if (!at || !(at->x >= left_ && at->x <= right_ && at->y >= top_ && at->y <= bottom_))
        return std::nullopt;
    return corner_at(at->x, at->y, nearness(deep));
}

std::vector<Vec3> PictureVolume::images_before_eye(const std::array<Vec3, 3>& triangle) const {
    std::vector<Vec3> images;
    for (const Vec3& point : clipped_by({triangle.begin(), triangle.end()},
                                        [&](const Vec3& p) { return depth(p) - near_; }))
        if (const auto at = camera_.project(point))
            images.emplace_back(at->x, at->y, nearness(depth(point)));
    return images;
}

std::vector<ScreenTriangle> PictureVolume::clipped(const std::array<Vec3, 3>& triangle) const {
    std::vector<Vec3> polygon = images_before_eye(triangle);
    polygon = clipped_by(polygon, [&](const Vec3& p) { return p.x - left_; });
    polygon = clipped_by(polygon, [&](const Vec3& p) { return right_ - p.x; });
    polygon = clipped_by(polygon, [&](const Vec3& p) { return p.y - top_; });
    polygon = clipped_by(polygon, [&](const Vec3& p) { return bottom_ - p.y; });
    std::vector<ScreenTriangle> parts;
    const auto corner = [&](std::size_t i) {
        return corner_at(polygon[i].x, polygon[i].y, polygon[i].z);
    };
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        parts.push_back({corner(0), corner(i), corner(i + 1)});
    return parts;
}

} // namespace keiko
