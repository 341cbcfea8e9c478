#include "keiko/workflow/curve_painter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {

CurvePainter::CurvePainter(const Film& film, const Camera& camera)
    : depth_(film.aovs.at(Aov::depth)), camera_(camera) {}

std::vector<Vec2> CurvePainter::drawn(std::span<const Vec3> points, double step) const {
    std::vector<Vec2> line;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Vec3 &a = points[i - 1], &b = points[i];
        const int steps = steps_between(a, b, step);
        for (int k = i == 1 ? 0 : 1; k <= steps; ++k)
            line.push_back(pixel(a + (b - a) * (static_cast<double>(k) / steps)));
    }
    return line;
}

int CurvePainter::steps_between(const Vec3& a, const Vec3& b, double step) const {
    const auto from = project(camera_, a), to = project(camera_, b);
    constexpr double most = 1000;
    if (!from || !to) return 1;
    return static_cast<int>(std::clamp((*to - *from).length() / step, 1.0, most));
}

Vec2 CurvePainter::pixel(const Vec3& place) const {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const auto at = project(camera_, place);
    return at && seen(*at, place) ? *at : Vec2(none, none);
}

/// True if a place is as near as the surface at its pixel or one beside it: curves on silhouettes
/// are visible.
bool CurvePainter::seen(const Vec2& at, const Vec3& place) const {
    constexpr double slack = 2e-3; // share of the distance to the camera
    const Ray ray = camera_.ray(at.x, at.y);
    const double distance = (place - ray.origin).dot(ray.direction);
    const int x = static_cast<int>(std::floor(at.x)), y = static_cast<int>(std::floor(at.y));
    double farthest = 0;
    for (int j = std::max(y - 1, 0); j <= std::min(y + 1, depth_.height - 1); ++j)
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, depth_.width - 1); ++i)
            if (const double depth{*depth_.pixel(i, j)}; std::isfinite(depth))
                farthest = std::max(farthest, depth);
    return distance <= farthest * (1 + slack);
}

} // namespace keiko
