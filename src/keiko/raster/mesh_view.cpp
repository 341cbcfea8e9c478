#include "keiko/raster/mesh_view.h"

#include "keiko/raster/painter.h"
#include "keiko/raster/scan_line.h"
#include "keiko/raster/smooth_shading.h"
#include "keiko/raster/z_buffer.h"

#include <utility>

namespace keiko {
namespace {

ItemBuffer visible_triangles(const SurfaceMesh& mesh, const Camera& camera, const Job& job,
                             HiddenSurfaces by) {
    if (by == HiddenSurfaces::scan_line) return scan_line(mesh, camera, job);
    if (by == HiddenSurfaces::painter) return painted_triangles(mesh, camera, job);
    return z_buffer(mesh, camera, job);
}

Ray mirrored_by(const MeshPlace& place, const Ray& sight) {
    Ray ray;
    ray.origin = place.position, ray.direction = reflect(sight.direction, place.normal);
    return ray;
}

} // namespace

MeshView::MeshView(const SurfaceMesh& mesh, const Camera& camera, const Job& job, HiddenSurfaces by)
    : MeshView(mesh, camera, visible_triangles(mesh, camera, job, by)) {}

MeshView::MeshView(const SurfaceMesh& mesh, const Camera& camera, ItemBuffer items)
    : mesh_(mesh), camera_(camera), prepared_(camera), items_(std::move(items)) {}

std::array<Vec3, 3> MeshView::corners(std::uint32_t triangle) const {
    const auto& [a, b, c] = mesh_.triangles[triangle];
    return {mesh_.positions[a], mesh_.positions[b], mesh_.positions[c]};
}

Vec3 MeshView::facet_normal(std::uint32_t triangle) const {
    const auto [a, b, c] = corners(triangle);
    return (b - a).cross(c - a).normalized();
}

std::array<Vec3, 3> MeshView::corner_normals(std::uint32_t triangle) const {
    const auto& [a, b, c] = mesh_.triangles[triangle];
    std::array<Vec3, 3> normals{mesh_.normals[a], mesh_.normals[b], mesh_.normals[c]};
    for (Vec3& normal : normals)
        if (normal == Vec3(0)) normal = facet_normal(triangle);
    return normals;
}

MeshPlace MeshView::place(std::uint32_t triangle, const Vec3& weights) const {
    return {triangle, weights, mixed(weights, corners(triangle)),
            mixed_normal(weights, corner_normals(triangle))};
}

std::optional<MeshPlace> MeshView::at(int x, int y) const {
    const std::uint32_t triangle = items_.at(x, y);
    if (triangle == no_index) return std::nullopt;
    const Ray sight = prepared_.ray(x + 0.5, y + 0.5);
    return place(triangle, weights_within(ray_weights(corners(triangle), sight)));
}

Ray MeshView::mirrored_at(const Vec2& pixel, std::uint32_t triangle) const {
    const Ray sight = prepared_.ray(pixel.x, pixel.y);
    return mirrored_by(place(triangle, ray_weights(corners(triangle), sight)), sight);
}

Ray MeshView::mirrored(int x, int y, const MeshPlace& place) const {
    const auto beside = [&](double dx, double dy) {
        return mirrored_at(Vec2(x + 0.5 + dx, y + 0.5 + dy), place.triangle);
    };
    Ray ray = mirrored_by(place, prepared_.ray(x + 0.5, y + 0.5));
    const Ray right = beside(0.5, 0), left = beside(-0.5, 0);
    const Ray below = beside(0, 0.5), above = beside(0, -0.5);
    ray.differentials = RayDifferentials{.origin_dx = right.origin - left.origin,
                                         .origin_dy = below.origin - above.origin,
                                         .direction_dx = right.direction - left.direction,
                                         .direction_dy = below.direction - above.direction};
    return ray;
}

} // namespace keiko
