#pragma once

#include "keiko/base/export.h"
#include "keiko/math/vec.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// A number at each corner of a mesh.
struct MeshField {
    std::string name;           ///< "mean", say
    std::string unit;           ///< "1/mm"
    std::vector<double> values; ///< one a corner; no number where the surface has none
};

/// A body in triangles, whose corners, normals and fields are those of the exact surface.
struct SurfaceMesh {
    std::string source;                                  ///< file of the body
    std::vector<Vec3> positions;                         ///< corners, world, mm
    std::vector<Vec3> normals;                           ///< unit, outward; 0 where there is none
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< counter-clockwise from outside
    std::vector<std::uint32_t> faces;                    ///< a triangle: number of its face
    std::vector<MeshField> fields;                       ///< the first one gives the colours
    double deviation = 0;                ///< mm, largest of the surface from the triangles
    std::vector<std::string> lost_faces; ///< a line for each face without triangles
};

} // namespace keiko
