#include "keiko/render/caustics/light_chart.h"

#include "keiko/light/luminance/photometry.h"
#include "keiko/light/spotlight/point_light.h"

#include <array>
#include <cmath>
#include <variant>

namespace keiko {
namespace {

std::array<Vec3, 8> corners_of(const Box3& box) {
    std::array<Vec3, 8> corners;
    for (unsigned i = 0; i < corners.size(); ++i)
        corners[i] = Vec3(i & 1 ? box.upper.x : box.lower.x, i & 2 ? box.upper.y : box.lower.y,
                          i & 4 ? box.upper.z : box.lower.z);
    return corners;
}

Box3 around(std::span<const Box3> boxes) {
    Box3 all;
    for (const Box3& box : boxes) all.extend(box);
    return all;
}

} // namespace

LightChart::LightChart(const PreparedSource& source, const Vec3& origin, const Vec3& forward,
                       bool parallel)
    : source_(&source), origin_(origin), forward_(forward), parallel_(parallel) {
    const Vec3 beside = std::abs(forward.z) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0);
    right_ = forward.cross(beside).normalized();
    up_ = right_.cross(forward);
}

Ray LightChart::ray(const Vec2& at) const {
    const Vec3 aside = right_ * at.x + up_ * at.y;
    Ray ray;
    ray.origin = parallel_ ? origin_ + aside : origin_;
    ray.direction = parallel_ ? forward_ : forward_ + aside;
    RayDifferentials& rates = ray.differentials.emplace();
    (parallel_ ? rates.origin_dx : rates.direction_dx) = right_;
    (parallel_ ? rates.origin_dy : rates.direction_dy) = up_;
    return ray;
}

Rgb LightChart::flux(const Vec2& at) const {
    const Vec3 direction = ray(at).direction;
    return std::visit(
        [&](const auto& light) {
            using Light = std::decay_t<decltype(light)>;
            if constexpr (PointLight<Light>) {
                // The solid angle of an area of the plane at the distance 1.
                const double length = direction.length();
                return intensity_towards(light, origin_ + direction) / (length * length * length);
            } else if constexpr (std::same_as<Light, Sun>) {
                return light.illuminance * metres(metres(1));
            } else {
                return Rgb();
            }
        },
        source_->kind());
}

double LightChart::spread(const Vec3& place) const {
    const double distance = (place - origin_).dot(forward_);
    return parallel_ ? 1 : distance * distance;
}

bool LightChart::reaches(const Vec3& place) const {
    const auto* sun = std::get_if<Sun>(&source_->kind());
    return !sun || sun->way_to(place).has_value();
}

Vec3 LightChart::start_in_medium(const Vec3& place) const {
    const auto* sun = std::get_if<Sun>(&source_->kind());
    return sun ? place + sun->towards() * sun->way_to(place).value_or(0) : origin_;
}

Vec2 LightChart::coordinates(const Vec3& place) const {
    const Vec3 way = place - origin_;
    const Vec2 aside(way.dot(right_), way.dot(up_));
    return parallel_ ? aside : aside / way.dot(forward_);
}

/// A box that reaches behind the light of a point may be anywhere before it.
void LightChart::cover(std::span<const Box3> boxes) {
    const Box2 square{Vec2(-1), Vec2(1)};
    for (const Box3& box : boxes) {
        int before = 0;
        Box2 part;
        for (const Vec3& corner : corners_of(box)) {
            const bool is_before = parallel_ || (corner - origin_).dot(forward_) > 0;
            before += is_before ? 1 : 0;
            if (is_before) part.extend(coordinates(corner));
        }
        if (before == 0) continue;
        range_.extend(before == 8 ? part : square);
    }
}

/// Makes the charts of a source.
class ChartsOf {
public:
    ChartsOf(const PreparedSource& source, std::span<const Box3> boxes, const Box3& scene)
        : source_(source), boxes_(boxes), all_(around(boxes)), scene_(scene) {}

    template <PointLight Light>
    std::vector<LightChart> operator()(const Light& light) const {
        const Vec3 way = all_.center() - light.position;
        // Seen under less than 30 degrees off the middle, all lies well before one plane.
        if (all_.size() < way.length()) return covered({chart(light.position, way.normalized())});
        std::vector<LightChart> sides;
        for (unsigned axis = 0; axis < 3; ++axis)
            for (const double sense : {-1.0, 1.0}) {
                Vec3 forward(0);
                forward[axis] = sense;
                sides.push_back(chart(light.position, forward));
            }
        sides = covered(std::move(sides));
        for (LightChart& side : sides) side.range_ = side.range_.intersection({Vec2(-1), Vec2(1)});
        std::erase_if(sides, [](const LightChart& side) { return side.range_.empty(); });
        return sides;
    }
    std::vector<LightChart> operator()(const Sun& sun) const {
        const Vec3 forward = sun.direction.normalized();
        const Vec3 before = scene_.center() - forward * scene_.size();
        return covered({LightChart(source_, before, forward, true)});
    }
    template <class Light>
    std::vector<LightChart> operator()(const Light&) const {
        return {};
    }

private:
    LightChart chart(const Vec3& from, const Vec3& forward) const {
        return {source_, from, forward, false};
    }
    std::vector<LightChart> covered(std::vector<LightChart> charts) const {
        for (LightChart& chart : charts) chart.cover(boxes_);
        std::erase_if(charts, [](const LightChart& chart) { return chart.range_.empty(); });
        return charts;
    }

    const PreparedSource& source_;
    std::span<const Box3> boxes_;
    Box3 all_, scene_;
};

bool casts_caustics(const PreparedSource& source) {
    return std::visit(
        []<class Light>(const Light&) { return PointLight<Light> || std::same_as<Light, Sun>; },
        source.kind());
}

std::vector<LightChart> charts_of(const PreparedSource& source, std::span<const Box3> boxes,
                                  const Box3& scene) {
    if (boxes.empty()) return {};
    return std::visit(ChartsOf(source, boxes, scene), source.kind());
}

} // namespace keiko
