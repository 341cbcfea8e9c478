#pragma once

#include "keiko/base/export.h"

#include <string_view>

namespace KEIKO_API keiko {

/// Rules by which the luminance of a mesh is known at a pixel.
enum class MeshShading {
    constant, ///< one luminance a triangle, that of its middle under its own normal
    gouraud,  ///< those of the corners, mixed [Gouraud1971]
    phong     ///< of each pixel, under the mixed normals of the corners [Phong1975]
};

/// "constant", "gouraud", "phong"
std::string_view name_of(MeshShading shading);

/// Algorithms that find the triangle of each pixel. They find the same but where
/// depths agree to rounding.
enum class HiddenSurfaces {
    z_buffer,  ///< by depths of pixels, in tiles [Catmull1974]
    scan_line, ///< by spans of rows [Sutherland1974]
    painter    ///< by priority, from the back to the front [Fuchs1980]
};

/// Algorithms that find the pixels of a mesh in the shadow of a light without extent. They find the
/// same but at edges of shadows; `map` has errors of its own pixels.
enum class MeshShadows {
    none,      ///< no shadows
    ray,       ///< by rays to the light [Appel1968]
    scan_line, ///< by edges projected onto the spans of rows [BouknightKelley1970]
    map,       ///< by what the light sees, in two stages [Williams1978]
    polygons,  ///< by the shadows that triangles cast on each other, as polygons [Atherton1978]
    volumes    ///< by the sides of the shadowed space before each pixel [Crow1977]
};

} // namespace keiko
