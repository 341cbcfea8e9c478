// OBJ cages: statements, tags and the manifold made of them
#include "keiko/import/subdivision/cage.h"

#include "tests/fuzz/memory_file.h"

namespace {

using namespace keiko;
using namespace keiko::subdivision;

void require_sound(const Cage& cage) {
    for (const std::uint32_t vertex : cage.corners)
        fuzz::require(vertex < cage.vertices.size(), "a corner is a vertex");
    for (const CageFace& face : cage.faces) {
        fuzz::require(face.corner_count >= 3, "a face has three corners");
        fuzz::require(face.first_corner + face.corner_count <= cage.corners.size(),
                      "the corners of a face are there");
        fuzz::require(face.group < cage.names.size() && face.material < cage.names.size(),
                      "the names of a face are there");
    }
    for (const CageCrease& crease : cage.creases) {
        fuzz::require(crease.a < cage.vertices.size() && crease.b < cage.vertices.size(),
                      "a crease joins vertices");
        fuzz::require(crease.sharpness >= 0 && crease.sharpness <= infinite_sharpness,
                      "a crease has a sharpness");
    }
    for (const CageCorner& corner : cage.sharp_corners)
        fuzz::require(corner.vertex < cage.vertices.size(), "a sharp corner is a vertex");
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::MemoryFile file;
    file.write(fuzz::text_of(data, size));
    fuzz::accepts([] { require_sound(read_cage(file.path())); });
    return 0;
}
