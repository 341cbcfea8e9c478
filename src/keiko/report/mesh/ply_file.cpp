#include "keiko/report/content/mesh_files.h"
#include "keiko/report/mesh/raw_bytes.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

std::string header(const SurfaceMesh& mesh) {
    std::string text = "ply\nformat binary_little_endian 1.0\ncomment Keiko, mm\nelement vertex " +
                       std::to_string(mesh.positions.size()) + "\n";
    for (const char* name : {"double x", "double y", "double z", "float nx", "float ny", "float nz",
                             "uchar red", "uchar green", "uchar blue"})
        text += "property " + std::string(name) + "\n";
    for (const MeshField& field : mesh.fields) text += "property double " + field.name + "\n";
    return text + "element face " + std::to_string(mesh.triangles.size()) +
           "\nproperty list uchar int vertex_indices\nproperty int face\nend_header\n";
}

std::uint8_t byte_of(double share) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
}

} // namespace

std::string ply_file(const SurfaceMesh& mesh, const std::optional<ValueRange>& range) {
    std::string bytes = header(mesh);
    const std::vector<Rgb> colors = corner_colors(mesh, range);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        for (unsigned k = 0; k < 3; ++k) append(bytes, mesh.positions[i][k]);
        for (unsigned k = 0; k < 3; ++k) append(bytes, static_cast<float>(mesh.normals[i][k]));
        for (const double part : {colors[i].r, colors[i].g, colors[i].b})
            append(bytes, byte_of(part));
        for (const MeshField& field : mesh.fields) append(bytes, field.values[i]);
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        append(bytes, std::uint8_t{3});
        for (const std::uint32_t corner : mesh.triangles[i])
            append(bytes, static_cast<std::int32_t>(corner));
        append(bytes, static_cast<std::int32_t>(mesh.faces[i]));
    }
    return bytes;
}

} // namespace keiko
