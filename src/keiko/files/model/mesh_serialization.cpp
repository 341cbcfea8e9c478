#include "keiko/files/model/mesh_serialization.h"

#include "keiko/base/error.h"
#include "keiko/files/model/byte_stream.h"

#include <cmath>

namespace keiko {
namespace {

constexpr std::string_view magic = "KEIKO-FM";
constexpr std::uint32_t version = 1;

void write(ByteWriter& out, const FaceMesh& face) {
    out.put(std::string_view(face.problem));
    out.put(face.deviation);
    out.put(static_cast<std::uint64_t>(face.uv.size()));
    for (const Vec2& uv : face.uv) out.put(uv.x), out.put(uv.y);
    out.put(static_cast<std::uint64_t>(face.triangles.size()));
    for (const auto& triangle : face.triangles)
        for (const std::uint32_t corner : triangle) out.put(corner);
}

double take_number(ByteReader& in) {
    const auto number = in.take<double>();
    if (!std::isfinite(number)) throw DamagedBytes("a number that is not finite");
    return number;
}

FaceMesh take_face(ByteReader& in) {
    FaceMesh face;
    face.problem = in.take_text();
    face.deviation = take_number(in);
    face.uv.resize(in.take_count(2 * sizeof(double)), Vec2(0));
    for (Vec2& uv : face.uv) uv.x = take_number(in), uv.y = take_number(in);
    face.triangles.resize(in.take_count(3 * sizeof(std::uint32_t)));
    for (auto& triangle : face.triangles)
        for (std::uint32_t& corner : triangle) {
            corner = in.take<std::uint32_t>();
            if (corner >= face.uv.size()) throw DamagedBytes("the index of no corner");
        }
    return face;
}

ModelMesh take_mesh(ByteReader in) {
    for (const char expected : magic)
        if (in.take<char>() != expected) throw DamagedBytes("it does not begin as one");
    if (in.take<std::uint32_t>() != version) throw DamagedBytes("it is of another version");
    constexpr std::size_t least_face = 4 * sizeof(std::uint64_t);
    const std::size_t count = in.take_count(least_face);
    ModelMesh mesh;
    for (std::size_t i = 0; i < count; ++i) mesh.push_back(take_face(in));
    if (in.remaining() > 0) throw DamagedBytes("bytes after the last face");
    return mesh;
}

} // namespace

std::string serialize(const ModelMesh& mesh) {
    std::string bytes;
    ByteWriter out([&](std::string_view piece) { bytes.append(piece); });
    out.put_bytes(magic);
    out.put(version);
    out.put(static_cast<std::uint64_t>(mesh.size()));
    for (const FaceMesh& face : mesh) write(out, face);
    out.flush();
    return bytes;
}

ModelMesh deserialize_mesh(std::string_view bytes, const std::string& file) {
    try {
        return take_mesh(ByteReader(bytes));
    } catch (const DamagedBytes& damage) {
        throw Error(file, "", std::string("its mesh is damaged: ") + damage.what());
    }
}

} // namespace keiko
