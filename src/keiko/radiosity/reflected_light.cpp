#include "keiko/radiosity/reflected_light.h"

#include "keiko/raster/smooth_shading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

/// Cells along an edge of the hemicube of a point in space.
constexpr int cells_in_space = 256;

using Triangle = std::array<Vec3, 3>;

Triangle corners_of(const RadiositySolution& s, std::size_t triangle) {
    const auto& [a, b, c] = s.triangles[triangle];
    return {s.corners[a], s.corners[b], s.corners[c]};
}

double longest_side(const Triangle& t) {
    return std::max({(t[1] - t[0]).length(), (t[2] - t[1]).length(), (t[0] - t[2]).length()});
}

Vec3 normal_of(const Triangle& t) {
    return (t[1] - t[0]).cross(t[2] - t[0]);
}

std::vector<Box3> boxes_of(const RadiositySolution& s) {
    std::vector<Box3> boxes(s.triangles.size());
    for (std::size_t t = 0; t < boxes.size(); ++t)
        for (const Vec3& corner : corners_of(s, t)) boxes[t].extend(corner);
    return boxes;
}

std::vector<std::array<Rgb, 2>> corner_light(const RadiositySolution& s) {
    std::vector<std::array<Rgb, 2>> light(s.corners.size());
    std::vector<double> areas(s.corners.size());
    for (std::size_t t = 0; t < s.triangles.size(); ++t) {
        const double area = normal_of(corners_of(s, t)).length() / 2;
        for (const std::uint32_t corner : s.triangles[t]) {
            areas[corner] += area;
            for (std::size_t side = 0; side < 2; ++side)
                light[corner][side] += s.light[t][side].arriving * area;
        }
    }
    for (std::size_t c = 0; c < light.size(); ++c)
        for (Rgb& value : light[c]) value = areas[c] > 0 ? value / areas[c] : Rgb();
    return light;
}

/// Shares of the corners at the foot of a point on the plane of a triangle, drawn to its inside.
Vec3 weights_at(const Triangle& t, const Vec3& point) {
    Ray down;
    down.origin = point, down.direction = normal_of(t);
    return weights_within(ray_weights(t, down));
}

} // namespace

ReflectedLight::ReflectedLight(RadiositySolution solution)
    : solution_(std::move(solution)),
      cube_(cells_in_space),
      tree_(boxes_of(solution_)),
      corner_light_(corner_light(solution_)) {
    mesh_.positions = solution_.corners;
    mesh_.triangles = solution_.triangles;
}

std::optional<Rgb> ReflectedLight::on_surface(const Vec3& point, const Vec3& normal) const {
    constexpr double least_cosine = 0.5;
    std::optional<std::uint32_t> nearest;
    Vec3 weights(0);
    double distance = std::numeric_limits<double>::infinity();
    const auto cosine = [&](std::uint32_t triangle) {
        return normal_of(corners_of(solution_, triangle)).normalized().dot(normal);
    };
    tree_.visit_near(point, distance, [&](std::uint32_t triangle) {
        if (!(std::abs(cosine(triangle)) >= least_cosine)) return distance;
        const Triangle corners = corners_of(solution_, triangle);
        const Vec3 shares = weights_at(corners, point);
        const double away = (mixed(shares, corners) - point).length();
        if (away < distance) nearest = triangle, weights = shares, distance = away;
        return distance;
    });
    if (!nearest || distance > longest_side(corners_of(solution_, *nearest))) return std::nullopt;
    const std::size_t side = cosine(*nearest) >= 0 ? 0 : 1;
    const auto& [a, b, c] = solution_.triangles[*nearest];
    return mixed(weights, std::array<Rgb, 3>{corner_light_[a][side], corner_light_[b][side],
                                             corner_light_[c][side]});
}

Rgb ReflectedLight::in_space(const Vec3& point, const Vec3& normal) const {
    Job alone; // many points at once have a thread each
    alone.threads = 1;
    const std::vector<double> factors = cube_.form_factors(mesh_, point, normal, alone);
    Rgb sum;
    for (std::size_t i = 0; i < factors.size(); ++i) {
        const bool back = i >= solution_.light.size();
        const auto& element = solution_.light[back ? i - solution_.light.size() : i];
        sum += element[back ? 1 : 0].radiosity * factors[i];
    }
    return sum;
}

Rgb ReflectedLight::arriving(const Vec3& point, const Vec3& normal) const {
    const std::optional<Rgb> light = on_surface(point, normal);
    return light ? *light : in_space(point, normal);
}

} // namespace keiko
