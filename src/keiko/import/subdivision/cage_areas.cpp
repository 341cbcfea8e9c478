#include "keiko/import/subdivision/cage_areas.h"

namespace keiko::subdivision {
namespace {

/// Whether all corners lie on one line, to within rounding.
bool on_a_line(const Cage& cage, const CageFace& face) {
    const Vec3& origin = cage.vertices[cage.corner(face, 0)];
    Vec3 longest(0);
    for (std::uint32_t k = 1; k < face.corner_count; ++k) {
        const Vec3 way = cage.vertices[cage.corner(face, k)] - origin;
        if (way.dot(way) > longest.dot(longest)) longest = way;
    }
    constexpr double rounding = 1e-12;
    const double square = longest.dot(longest);
    for (std::uint32_t k = 1; k < face.corner_count; ++k) {
        const Vec3 way = cage.vertices[cage.corner(face, k)] - origin;
        if (way.cross(longest).length() > rounding * square) return false;
    }
    return true;
}

} // namespace

void check_areas(Cage& cage, const CageLines& lines) {
    std::size_t flat = 0;
    std::string told;
    for (const CageFace& face : cage.faces) {
        if (!on_a_line(cage, face)) continue;
        constexpr std::size_t most_told = 8;
        if (++flat <= most_told) told += (told.empty() ? "" : ", ") + std::to_string(face.line);
    }
    if (flat == cage.faces.size())
        throw Error(lines.file(), "", "no face of the cage has an area: it is no surface");
    if (flat > 0)
        cage.diagnostics.push_back({Severity::warning, "",
                                    std::to_string(flat) + (flat == 1 ? " face" : " faces") +
                                        " of the cage without area (lines " + told +
                                        (flat > 8 ? ", ...)" : ")")});
}

} // namespace keiko::subdivision
