#include "keiko/base/error.h"
#include "keiko/film/tone_mapping.h"
#include "keiko/math/bounds.h"
#include "keiko/report/content/mesh_files.h"
#include "keiko/report/markup/json_text.h"
#include "keiko/report/mesh/raw_bytes.h"

#include <cmath>
#include <limits>

namespace keiko {
namespace {

// The numbers of the glTF 2.0 specification.
constexpr std::uint32_t magic = 0x46546C67, version = 2, json_chunk = 0x4E4F534A,
                        binary_chunk = 0x004E4942;
constexpr int float_type = 5126, index_type = 5125, corner_buffer = 34962, index_buffer = 34963;

/// Millimetres and z upwards become metres and y upwards, about the middle of the body: floats are
/// finest near 0.
struct GlbFrame {
    Vec3 middle;

    Vec3 direction(const Vec3& v) const { return {v.x, v.z, -v.y}; }
    Vec3 point(const Vec3& p) const { return direction(p - middle) * 1e-3; }
};

/// The binary chunk, and what JSON says of its parts.
struct GlbBuffer {
    std::string bytes;
    Json views = Json::array(), accessors = Json::array();

    void add(const char* type, std::size_t count, std::size_t size, int component, int target) {
        views.push_back({{"buffer", 0},
                         {"byteOffset", bytes.size() - size},
                         {"byteLength", size},
                         {"target", target}});
        accessors.push_back({{"bufferView", accessors.size()},
                             {"componentType", component},
                             {"count", count},
                             {"type", type}});
    }
    void add_vectors(const std::vector<Vec3>& vectors) {
        for (const Vec3& v : vectors)
            for (unsigned k = 0; k < 3; ++k) append(bytes, static_cast<float>(v[k]));
        add("VEC3", vectors.size(), 12 * vectors.size(), float_type, corner_buffer);
    }
};

Json vector_json(const Vec3& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

GlbBuffer buffer_of(const SurfaceMesh& mesh, const std::optional<ValueRange>& range) {
    Box3 box, world;
    for (const Vec3& p : mesh.positions) world.extend(p);
    const GlbFrame frame{world.center()};
    std::vector<Vec3> positions, normals, colors;
    for (const Vec3& p : mesh.positions)
        positions.push_back(frame.point(p)), box.extend(positions.back());
    for (const Vec3& n : mesh.normals)
        normals.push_back(n == Vec3(0) ? Vec3(0, 1, 0) : frame.direction(n));
    for (const Rgb& c : corner_colors(mesh, range))
        colors.emplace_back(srgb_eotf(c.r), srgb_eotf(c.g), srgb_eotf(c.b));
    GlbBuffer buffer;
    buffer.add_vectors(positions), buffer.add_vectors(normals), buffer.add_vectors(colors);
    buffer.accessors[0]["min"] = vector_json(box.lower),
    buffer.accessors[0]["max"] = vector_json(box.upper);
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t corner : triangle) append(buffer.bytes, corner);
    buffer.add("SCALAR", 3 * mesh.triangles.size(), 12 * mesh.triangles.size(), index_type,
               index_buffer);
    return buffer;
}

Json description(const SurfaceMesh& mesh, const GlbBuffer& buffer) {
    const Json primitive = {{"attributes", {{"POSITION", 0}, {"NORMAL", 1}, {"COLOR_0", 2}}},
                            {"indices", 3},
                            {"material", 0}};
    const Json material = {
        {"doubleSided", true},
        {"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 0.6}}}};
    return {{"asset", {{"version", "2.0"}, {"generator", "Keiko"}}},
            {"scene", 0},
            {"scenes", {{{"nodes", {0}}}}},
            {"nodes", {{{"mesh", 0}, {"name", mesh.source}}}},
            {"meshes", {{{"primitives", {primitive}}}}},
            {"materials", {material}},
            {"buffers", {{{"byteLength", buffer.bytes.size()}}}},
            {"bufferViews", buffer.views},
            {"accessors", buffer.accessors}};
}

/// Appends a chunk, filled up to four bytes.
void append_chunk(std::string& file, std::uint32_t type, std::string bytes, char filler) {
    bytes.resize((bytes.size() + 3) / 4 * 4, filler);
    append(file, static_cast<std::uint32_t>(bytes.size())), append(file, type);
    file += bytes;
}

} // namespace

std::string glb_file(const SurfaceMesh& mesh, const std::optional<ValueRange>& range) {
    const GlbBuffer buffer = buffer_of(mesh, range);
    std::string chunks;
    append_chunk(chunks, json_chunk, text_of(description(mesh, buffer)), ' ');
    append_chunk(chunks, binary_chunk, buffer.bytes, '\0');
    constexpr std::size_t head = 12;
    if (chunks.size() + head > std::numeric_limits<std::uint32_t>::max())
        throw Error(mesh.source, "",
                    "has too many triangles for a .glb file; allow more deviation");
    std::string file;
    append(file, magic), append(file, version);
    append(file, static_cast<std::uint32_t>(chunks.size() + head));
    return file + chunks;
}

} // namespace keiko
