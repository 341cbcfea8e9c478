#include "keiko/raster/averaged_normals.h"

#include <map>
#include <tuple>

namespace keiko {
namespace {

/// A corner of a face.
using Place = std::tuple<std::uint32_t, double, double, double>;

Place place_of(const SurfaceMesh& mesh, std::size_t triangle, std::uint32_t corner) {
    const Vec3& p = mesh.positions[corner];
    return {mesh.faces[triangle], p.x, p.y, p.z};
}

} // namespace

std::vector<Vec3> averaged_normals(const SurfaceMesh& mesh) {
    std::map<Place, Vec3> sums;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const Vec3 doubled_area =
            (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]);
        for (const std::uint32_t corner : mesh.triangles[t])
            sums.try_emplace(place_of(mesh, t, corner), Vec3(0)).first->second += doubled_area;
    }
    std::vector<Vec3> normals(mesh.positions.size(), Vec3(0));
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (const std::uint32_t corner : mesh.triangles[t])
            normals[corner] = sums.at(place_of(mesh, t, corner)).normalized();
    return normals;
}

} // namespace keiko
