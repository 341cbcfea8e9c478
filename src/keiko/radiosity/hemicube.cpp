#include "keiko/radiosity/hemicube.h"

#include "keiko/base/error.h"
#include "keiko/base/units.h"
#include "keiko/light/luminance/projected_solid_angle.h"
#include "keiko/math/unit_vectors.h"
#include "keiko/raster/z_buffer.h"

#include <array>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

/// Form factor of a square from the origin with the normal z.
double cell_factor(const Vec3& corner, const Vec3& u, const Vec3& v) {
    const std::array<Vec3, 4> corners{corner, corner + u, corner + u + v, corner + v};
    return projected_solid_angle(corners, Vec3(0), Vec3(0, 0, 1)) / std::numbers::pi;
}

/// Camera at a point whose picture plane is at distance 1, with pixels 2 / `cells` wide.
Camera face_camera(const Vec3& point, const Vec3& forward, const Vec3& up, int cells) {
    Camera camera;
    camera.eye = point;
    camera.target = point + forward;
    camera.up = up;
    camera.width = camera.height = cells;
    camera.vertical_fov = 90;
    return camera;
}

/// The upper half of such a picture.
Camera side_camera(const Vec3& point, const Vec3& forward, const Vec3& up, int cells) {
    Camera camera = face_camera(point, forward, up, cells);
    camera.height = cells / 2;
    camera.vertical_fov = radians_to_degrees(2 * std::atan(0.5));
    camera.shift = {0, cells / 4.0};
    return camera;
}

/// For each triangle the place in a list of all fronts, then all backs, of the face that it shows a
/// point.
std::vector<std::size_t> shown_faces(const SurfaceMesh& mesh, const Vec3& point) {
    std::vector<std::size_t> shown;
    shown.reserve(mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3& corner = mesh.positions[a];
        const Vec3 normal = (mesh.positions[b] - corner).cross(mesh.positions[c] - corner);
        const bool front = normal.dot(point - corner) > 0;
        shown.push_back(shown.size() + (front ? 0 : mesh.triangles.size()));
    }
    return shown;
}

} // namespace

Hemicube::Hemicube(int cells) : cells_(cells) {
    if (cells < 2 || cells > 4096 || cells % 2 != 0)
        throw FieldError("cells", "must be even, 2 to 4096");
    const double edge = 2.0 / cells;
    const Vec3 x(edge, 0, 0), y(0, edge, 0), z(0, 0, edge);
    for (int j = 0; j < cells; ++j)
        for (int i = 0; i < cells; ++i)
            top_.push_back(cell_factor({-1 + edge * i, -1 + edge * j, 1}, x, y));
    for (int j = 0; j < cells / 2; ++j)
        for (int i = 0; i < cells; ++i)
            side_.push_back(cell_factor({1, -1 + edge * i, edge * j}, y, z));
}

std::vector<double> Hemicube::form_factors(const SurfaceMesh& mesh, const Vec3& point,
                                           const Vec3& normal, const Job& job) const {
    std::vector<double> factors(2 * mesh.triangles.size());
    const std::vector<std::size_t> face_of = shown_faces(mesh, point);
    const auto add = [&](std::uint32_t triangle, double factor) {
        if (triangle != no_index) factors[face_of[triangle]] += factor;
    };
    const AxesAcross axes(normal, std::copysign(1.0, normal.z));
    const ItemBuffer above = z_buffer(mesh, face_camera(point, normal, axes.y, cells_), job);
    for (int y = 0; y < cells_; ++y)
        for (int x = 0; x < cells_; ++x) add(above.at(x, y), top(x, y));
    for (const Vec3& forward : {axes.x, axes.y, -axes.x, -axes.y}) {
        const ItemBuffer beside = z_buffer(mesh, side_camera(point, forward, normal, cells_), job);
        for (int y = 0; y < beside.height; ++y)
            for (int x = 0; x < cells_; ++x) add(beside.at(x, y), side(x, beside.height - 1 - y));
    }
    return factors;
}

} // namespace keiko
