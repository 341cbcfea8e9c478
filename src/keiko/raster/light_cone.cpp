#include "keiko/raster/light_cone.h"

#include "keiko/math/convex_clip.h"
#include "keiko/math/interval_set.h"
#include "keiko/raster/lit_pixels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace keiko {
namespace {

// Directions from the place are points (x, y) of the plane at distance 1 across the cone's axis,
// in which triangles are polygons and the sphere is a disc.

/// Radians between the lines across a disc and the axes of space. An edge that runs along a line
/// would be found on it as a whole or not at all, and many edges run along axes.
constexpr double oblique = 0.6;

/// The cone from a place to a sphere.
class LightCone {
public:
    LightCone(const Vec3& place, const LightSphere& sphere, double rounding)
        : place_(place),
          distance_((sphere.center - place).length()),
          nearest_(rounding),
          axis_((sphere.center - place) / distance_) {
        const double sine = sphere.radius / distance_;
        cosine_ = std::sqrt(1 - sine * sine), tangent_ = sine / cosine_;
        reach_ = distance_ * cosine_ * cosine_;
        const Vec3 beside = std::abs(axis_.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
        const Vec3 first = axis_.cross(beside).normalized(), second = axis_.cross(first);
        across_ = first * std::cos(oblique) + second * std::sin(oblique);
        up_ = axis_.cross(across_);
    }

    /// Radius of the disc.
    double tangent() const { return tangent_; }
    /// x, y and the distance along the axis of a vector.
    Vec3 turned(const Vec3& v) const { return {v.dot(across_), v.dot(up_), v.dot(axis_)}; }
    /// False if a box, by the ball around it, lies outside.
    bool meets(const Box3& box) const {
        const Vec3 middle = turned(box.center() - place_);
        const double radius = box.size() / 2;
        return middle.z >= -radius && middle.z <= reach_ + radius &&
               std::hypot(middle.x, middle.y) <= std::abs(middle.z) * tangent_ + radius / cosine_;
    }
    /// The image of what a triangle has between the place and the circle in which the cone touches
    /// the sphere: farther away the cone is wider than the sphere.
    std::vector<Vec2> image_of(const std::array<Vec3, 3>& triangle) const {
        std::vector<Vec3> corners, before;
        for (const Vec3& corner : triangle) corners.push_back(turned(corner - place_));
        clip_convex(
            corners, [&](std::size_t i) { return corners[i].z - nearest_; },
            [&](const Vec3& corner) { before.push_back(corner); });
        std::vector<Vec2> image;
        clip_convex(
            before, [&](std::size_t i) { return reach_ - before[i].z; },
            [&](const Vec3& p) { image.emplace_back(p.x / p.z, p.y / p.z); });
        return image;
    }

private:
    Vec3 place_;
    double distance_, nearest_;
    Vec3 axis_, across_{0}, up_{0};
    double cosine_ = 1, tangent_ = 0;
    double reach_ = 0; ///< distance along the axis of the circle in which both touch
};

/// The part of a line across the disc that a convex polygon covers; none if its end is before.
ParameterInterval covered(const std::vector<Vec2>& polygon, double y) {
    ParameterInterval part{std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        if ((a.y > y) == (b.y > y)) continue;
        const double x = a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y);
        part = {std::min(part.begin, x), std::max(part.end, x)};
    }
    return part;
}

/// Illuminance by the directions on a line, on a facet whose normal is `normal` in the frame of the
/// cone: the integral of normal . (x, y, 1) / (1 + x^2 + y^2)^2.
class ChordIntegral {
public:
    ChordIntegral(const Vec3& normal, double y)
        : constant_(normal.y * y + normal.z), slope_(normal.x), square_(1 + y * y) {}

    /// The part within [-reach, reach] from which the facet is lit; none if its end is before.
    ParameterInterval above(double reach) const {
        const double horizon = -constant_ / slope_;
        if (slope_ > 0) return {std::max(-reach, horizon), reach};
        if (slope_ < 0) return {-reach, std::min(reach, horizon)};
        return {-reach, constant_ > 0 ? reach : -reach};
    }
    double over(const ParameterInterval& part) const { return up_to(part.end) - up_to(part.begin); }

private:
    double up_to(double x) const {
        const double c = std::sqrt(square_), both = square_ + x * x;
        return constant_ * (x / both + std::atan(x / c) / c) / (2 * square_) - slope_ / (2 * both);
    }

    double constant_, slope_, square_;
};

double share_lit(const LightCone& cone, const std::vector<std::vector<Vec2>>& images,
                 const Vec3& normal, int chords) {
    double lit = 0, all = 0;
    for (int k = 1; k <= chords; ++k) {
        const double angle = std::numbers::pi * k / (chords + 1);
        const double y = cone.tangent() * std::cos(angle), weight = std::sin(angle);
        const ChordIntegral integral(normal, y);
        const ParameterInterval whole = integral.above(cone.tangent() * std::sin(angle));
        if (!(whole.begin < whole.end)) continue;
        all += weight * integral.over(whole), lit += weight * integral.over(whole);
        std::vector<ParameterInterval> hidden;
        for (const std::vector<Vec2>& image : images) {
            const ParameterInterval part = covered(image, y);
            hidden.push_back({std::max(part.begin, whole.begin), std::min(part.end, whole.end)});
        }
        std::erase_if(hidden, [](const auto& part) { return !(part.begin < part.end); });
        for (const ParameterInterval& part : IntervalSet(std::move(hidden)))
            lit -= weight * integral.over(part);
    }
    return all > 0 ? std::clamp(lit / all, 0.0, 1.0) : 0;
}

} // namespace

Image lit_by_cones(const MeshView& view, const ShadowCasters& casters, const LightSphere& sphere,
                   const Job& job, int chords) {
    const auto share = [&](const MeshPlace& place, int, int) {
        if ((place.position - sphere.center).length() <= sphere.radius) return 0.0;
        const LightCone cone(place.position, sphere, casters.rounding());
        std::vector<std::vector<Vec2>> images;
        casters.tree().any_of([&](const Box3& box) { return cone.meets(box); },
                              [&](std::uint32_t triangle) {
                                  if (triangle != place.triangle)
                                      images.push_back(cone.image_of(casters.corners(triangle)));
                                  return false;
                              });
        const Vec3 normal = view.facet_normal(place.triangle);
        const bool outside = normal.dot(eye_of(view.camera()).way_to(place.position)) < 0;
        return share_lit(cone, images, cone.turned(outside ? normal : -normal), chords);
    };
    return share_of_pixels(view, job, share);
}

} // namespace keiko
