#include "keiko/raster/shadow_casters.h"

#include "keiko/geometry/model/surface_model.h"
#include "keiko/raster/smooth_shading.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace keiko {
namespace {

/// Share of the size of a mesh within which places count as one.
constexpr double rounding_share = 1e-9;

std::vector<Box3> boxes_of(const SurfaceMesh& mesh) {
    std::vector<Box3> boxes(mesh.triangles.size());
    for (std::size_t t = 0; t < boxes.size(); ++t)
        for (const std::uint32_t corner : mesh.triangles[t])
            boxes[t].extend(mesh.positions[corner]);
    return boxes;
}

Box3 box_around(const SurfaceMesh& mesh) {
    Box3 box;
    for (const Vec3& position : mesh.positions) box.extend(position);
    return box;
}

/// From a place to a light, up to parameter `end`.
struct WayToLight {
    Vec3 origin, direction, per_direction;
    double end;

    WayToLight(const Vec3& place, const Viewpoint& light)
        : origin(place),
          direction(-light.way_to(place)),
          per_direction(Vec3(1) / direction),
          end(light.infinite() ? std::numeric_limits<double>::infinity() : 1) {}

    /// By the slabs of the box. A way that runs along a slab is within it, borders included, or
    /// not: 0 times infinity is no number.
    bool meets(const Box3& box) const {
        double first = 0, last = end;
        for (unsigned i = 0; i < 3; ++i) {
            if (!std::isfinite(per_direction[i])) {
                if (!(origin[i] >= box.lower[i] && origin[i] <= box.upper[i])) return false;
                continue;
            }
            const double a = (box.lower[i] - origin[i]) * per_direction[i];
            const double b = (box.upper[i] - origin[i]) * per_direction[i];
            if (std::min(a, b) > first) first = std::min(a, b);
            if (std::max(a, b) < last) last = std::max(a, b);
        }
        return first <= last;
    }
    Ray ray() const { return {.origin = origin, .direction = direction, .excluded = {}}; }
};

} // namespace

ShadowCasters::ShadowCasters(const SurfaceMesh& mesh)
    : mesh_(mesh),
      bounds_(box_around(mesh)),
      rounding_(rounding_share * bounds_.size()),
      tree_(boxes_of(mesh)) {}

std::array<Vec3, 3> ShadowCasters::corners(std::uint32_t triangle) const {
    const auto& [a, b, c] = mesh_.triangles[triangle];
    return {mesh_.positions[a], mesh_.positions[b], mesh_.positions[c]};
}

bool ShadowCasters::hold(std::uint32_t triangle, const Viewpoint& light) const {
    if (light.infinite()) return false;
    const auto [a, b, c] = corners(triangle);
    const Vec3 normal = (b - a).cross(c - a);
    return std::abs(normal.dot(light.way_to(a))) <= rounding_ * normal.length();
}

template <class Visit>
bool ShadowCasters::any_between(const Vec3& place, const Viewpoint& light,
                                const Visit& visit) const {
    const WayToLight way(place, light);
    const Ray ray = way.ray();
    const double square = way.direction.length2(), first = rounding_ / std::sqrt(square);
    return tree_.any_of([&](const Box3& box) { return way.meets(box); },
                        [&](std::uint32_t triangle) {
                            const auto corners = this->corners(triangle);
                            const Vec3 shares = ray_weights(corners, ray);
                            if (!(std::min({shares.x, shares.y, shares.z}) >= 0)) return false;
                            const Vec3 met = mixed(shares, corners);
                            const double t = (met - place).dot(way.direction) / square;
                            // Of a triangle edge on, ray_weights() are those of its middle.
                            const bool on_way = (met - ray.at(t)).length() <= 1e3 * rounding_;
                            return on_way && t > first && t < way.end && !hold(triangle, light) &&
                                   visit(triangle);
                        });
}

bool ShadowCasters::hide(const Vec3& place, const Viewpoint& light, std::uint32_t except) const {
    return any_between(place, light, [&](std::uint32_t triangle) { return triangle != except; });
}

int ShadowCasters::layers(const Vec3& place, const Viewpoint& light) const {
    int count = 0;
    any_between(place, light, [&](std::uint32_t) {
        ++count;
        return false;
    });
    return count;
}

} // namespace keiko
