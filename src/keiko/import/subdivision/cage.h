#pragma once

#include "keiko/base/error.h"
#include "keiko/math/bounds.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace keiko::subdivision {

/// Rule by which a cage is subdivided.
enum class Scheme {
    catmull_clark, ///< faces of any number of corners
    loop           ///< triangles alone
};

/// Rule of the limit surface at the border of the cage.
enum class BoundaryRule {
    none,           ///< faces at a border carry no surface unless the border is a crease
    edge_only,      ///< the border is a cubic spline; corners are round
    edge_and_corner ///< vertices of one face alone are interpolated as well
};

/// How the sharpness of a crease becomes less from level to level.
enum class CreaseMethod {
    uniform, ///< each edge's sharpness by 1
    chaikin  ///< a mean of each edge's and its neighbours' along the crease, by 1
};

/// Weights of triangles in the Catmull-Clark scheme.
enum class TriangleRule {
    catmull_clark, ///< those of any other face
    smooth         ///< those that OpenSubdiv offers for smoother triangles
};

/// Sharpness from which an edge or a vertex stays sharp for ever.
constexpr double infinite_sharpness = 10;

/// A face of a cage.
struct CageFace {
    std::uint32_t first_corner = 0, corner_count = 0; ///< into Cage::corners
    std::uint32_t line = 0;                           ///< of the file
    std::uint32_t group = 0, material = 0;            ///< into Cage::names
    bool hole = false;                                ///< it carries no surface
};

/// An edge of a cage that is sharp.
struct CageCrease {
    std::uint32_t a = 0, b = 0; ///< vertices of the edge
    double sharpness = 0;       ///< from 0
    std::uint32_t line = 0;     ///< of the file
};

/// A vertex of a cage that is sharp.
struct CageCorner {
    std::uint32_t vertex = 0; ///< into Cage::vertices
    double sharpness = 0;     ///< from 0
};

/// A control mesh with its tags, as the file has it.
struct Cage {
    Scheme scheme = Scheme::catmull_clark;                ///< of all faces
    BoundaryRule boundary = BoundaryRule::edge_only;      ///< of all borders
    CreaseMethod crease_method = CreaseMethod::uniform;   ///< of all creases
    TriangleRule triangles = TriangleRule::catmull_clark; ///< without effect in a Loop cage

    std::vector<Vec3> vertices;            ///< in units of the file
    std::vector<std::uint32_t> corners;    ///< vertices of the faces, one face after the other
    std::vector<CageFace> faces;           ///< in the order of the file, holes included
    std::vector<CageCrease> creases;       ///< in the order of the tags
    std::vector<CageCorner> sharp_corners; ///< in the order of the tags
    std::vector<std::string> names{""};    ///< of groups and materials; the first is none
    Diagnostics diagnostics;               ///< what reading the file has found

    /// The box around the faces, in units of the file; vertices of no face may be anywhere.
    Box3 box() const {
        Box3 box;
        for (const std::uint32_t vertex : corners) box.extend(vertices[vertex]);
        return box;
    }
    /// Diagonal of that box.
    double size() const { return box().size(); }
    /// Vertex of corner `k` of a face; k counts on around the face.
    std::uint32_t corner(const CageFace& face, std::uint32_t k) const {
        return corners[face.first_corner + k % face.corner_count];
    }
};

/// Reads the polygons of an OBJ file as a control mesh: `v`; `f` with three or more corners
/// "v", "v/vt", "v//vn" or "v/vt/vn", counted from 1 or backwards from -1; `g`, `o` and `usemtl`
/// name the faces after them. `t` holds a tag as OpenSubdiv writes it, "t NAME
/// INTEGERS/FLOATS/STRINGS values", counted from 0. Tags of parts are
///   crease (two vertices or a chain of them; one sharpness or one an edge), corner and hole.
/// Tags of the whole cage are
///   interpolateboundary (0 none, 1 edge and corner, 2 edge only: the default),
///   creasemethod (normal, chaikin), smoothtriangles (catmark, smooth), scheme (catmark, loop).
/// Without `t scheme` a cage of triangles alone is a Loop cage, any other Catmull-Clark's.
/// Texture, normals, points, lines and rendering hints are skipped. Throws Error with the line
/// for anything else, and for a mesh in which an edge has more than two faces or two that run
/// the same way along it.
Cage read_cage(const std::filesystem::path& path);

} // namespace keiko::subdivision
