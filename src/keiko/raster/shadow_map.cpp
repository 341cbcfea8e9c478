#include "keiko/raster/shadow_map.h"

#include "keiko/base/units.h"
#include "keiko/raster/lit_pixels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace keiko {
namespace {

/// Share by which maps are larger than what they show.
constexpr double margin = 1.01;
/// Sine of half the widest angle that one map sees: its pixels are four times as large at the rim.
constexpr double widest = 0.87;

Camera square_camera(int size, const Vec3& eye, const Vec3& target) {
    Camera camera;
    camera.eye = eye, camera.target = target;
    camera.width = camera.height = size;
    return camera;
}

Camera parallel_camera(const Box3& bounds, const Viewpoint& light, int size) {
    const Vec3 middle = bounds.center();
    Camera camera = square_camera(size, middle + light.place() * bounds.size(), middle);
    camera.projection = Projection::orthographic;
    camera.orthographic_height = margin * bounds.size();
    return camera;
}

std::vector<Camera> cameras_of(const Box3& bounds, const Viewpoint& light, int size) {
    if (light.infinite()) return {parallel_camera(bounds, light, size)};
    const Vec3 eye = light.place(), to_middle = bounds.center() - eye;
    const double sine = margin * bounds.size() / 2 / to_middle.length();
    if (sine < widest) {
        Camera camera = square_camera(size, eye, bounds.center());
        camera.vertical_fov = radians_to_degrees(2 * std::asin(sine));
        return {camera};
    }
    std::vector<Camera> around;
    for (unsigned axis = 0; axis < 3; ++axis)
        for (const double side : {1.0, -1.0}) {
            Vec3 way(0);
            way[axis] = side;
            around.push_back(square_camera(size, eye, eye + way));
            around.back().vertical_fov = 90;
        }
    return around;
}

/// The mesh of casters in which triangles that hold the light shrink to a corner; nullopt if none
/// does.
std::optional<SurfaceMesh> without_held(const ShadowCasters& casters, const Viewpoint& light) {
    std::optional<SurfaceMesh> mesh;
    for (std::uint32_t t = 0; t < casters.mesh().triangles.size(); ++t) {
        if (!casters.hold(t, light)) continue;
        if (!mesh) mesh = casters.mesh();
        mesh->triangles[t].fill(mesh->triangles[t][0]);
    }
    return mesh;
}

} // namespace

ShadowMap::ShadowMap(const ShadowCasters& casters, const Viewpoint& light, int size, const Job& job)
    : light_(light),
      cameras_(cameras_of(casters.bounds(), light, size)),
      own_(without_held(casters, light)) {
    for (const Camera& camera : cameras_)
        views_.emplace_back(own_ ? *own_ : casters.mesh(), camera, job);
}

bool ShadowMap::sees(const Vec3& place, std::uint32_t triangle) const {
    for (const MeshView& view : views_) {
        const Camera& camera = view.camera();
        const auto at = project(camera, place);
        if (!at || !(at->x >= 0 && at->x < camera.width && at->y >= 0 && at->y < camera.height))
            continue;
        const std::uint32_t first =
            view.items().at(static_cast<int>(at->x), static_cast<int>(at->y));
        if (first == no_index || first == triangle) return true;
        const double depth = (place - camera.eye).dot(camera.axes().forward);
        const double pixel = camera.pixel_size() * (light_.infinite() ? 1 : depth);
        const Vec3 normal = view.facet_normal(first), corner = view.corners(first)[0];
        const double off = normal.dot(place - corner);
        return (normal.dot(light_.way_to(corner)) > 0 ? off : -off) <= pixel;
    }
    return true;
}

Image lit_by_map(const MeshView& view, const ShadowCasters& casters, const Viewpoint& light,
                 const Job& job, int size) {
    const ShadowMap map(casters, light, size, job);
    return lit_pixels_where(view, light, job, [&](const MeshPlace& place, int, int) {
        return map.sees(place.position, place.triangle);
    });
}

} // namespace keiko
