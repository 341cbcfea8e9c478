#include "keiko/raster/panel_points.h"

#include "keiko/math/polygon.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>

namespace keiko {
namespace {

/// Share of the polygon's area up to which three corners are in line.
constexpr double in_line = 1e-12;

/// Cuts the ears off a polygon one by one.
class EarCutter {
public:
    using Triangle = std::array<Vec3, 3>;

    EarCutter(std::span<const Vec3> corners, const Vec3& normal)
        : left_(corners.begin(), corners.end()),
          normal_(normal),
          least_(in_line * std::abs(polygon_normal(corners).dot(normal))) {}

    /// The next ear; nullopt when nothing is left.
    std::optional<Triangle> next() {
        while (left_.size() >= 3) {
            const std::size_t tip = next_tip();
            const Triangle ear = at(tip);
            left_.erase(std::next(left_.begin(), static_cast<std::ptrdiff_t>(tip)));
            if (area_of(ear[0], ear[1], ear[2]) > least_) return ear;
        }
        return std::nullopt;
    }

private:
    /// Twice the area; negative if clockwise.
    double area_of(const Vec3& a, const Vec3& b, const Vec3& c) const {
        return (b - a).cross(c - a).dot(normal_);
    }
    /// A corner between its neighbours.
    Triangle at(std::size_t i) const {
        const std::size_t n = left_.size();
        return {left_[(i + n - 1) % n], left_[i], left_[(i + 1) % n]};
    }
    /// True if no other corner lies in a triangle or on its border.
    bool is_empty(const Triangle& t) const {
        return std::none_of(left_.begin(), left_.end(), [&](const Vec3& p) {
            return std::find(t.begin(), t.end(), p) == t.end() && area_of(t[0], t[1], p) >= 0 &&
                   area_of(t[1], t[2], p) >= 0 && area_of(t[2], t[0], p) >= 0;
        });
    }
    /// The corner to cut off: one in line with its neighbours or the tip of an ear. Where rounding
    /// leaves none, it is the one that changes the area least.
    std::size_t next_tip() const {
        std::size_t flattest = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = 1; k <= left_.size(); ++k) {
            const std::size_t i = k % left_.size();
            const Triangle here = at(i);
            const double area = area_of(here[0], here[1], here[2]);
            if (std::abs(area) <= least_ || (area > 0 && is_empty(here))) return i;
            if (std::abs(area) < least) least = std::abs(area), flattest = i;
        }
        return flattest;
    }

    std::vector<Vec3> left_;
    Vec3 normal_;
    double least_; ///< twice the area up to which corners are in line, mm2
};

/// Adds the middles of the parts of a triangle of a panel.
void add_points(const std::array<Vec3, 3>& triangle, int parts, const Vec3& normal,
                std::vector<EmittingPoint>& points) {
    const Vec3 across = (triangle[1] - triangle[0]) / parts,
               along = (triangle[2] - triangle[0]) / parts;
    const double area = across.cross(along).dot(normal) / 2;
    for (int i = 0; i < parts; ++i)
        for (int j = 0; i + j < parts; ++j) {
            const Vec3 corner = triangle[0] + across * i + along * j;
            points.push_back({corner + (across + along) / 3, normal, area});
            if (i + j + 1 < parts)
                points.push_back({corner + (across + along) * 2 / 3, normal, area});
        }
}

} // namespace

std::vector<EmittingPoint> points_of_panel(std::span<const Vec3> corners, int parts) {
    const Vec3 normal = polygon_normal(corners).normalized();
    std::vector<EmittingPoint> points;
    EarCutter cutter(corners, normal);
    while (const auto ear = cutter.next()) add_points(*ear, parts, normal, points);
    return points;
}

} // namespace keiko
