#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/model/surface_mesh.h"
#include "keiko/raster/triangle_limit.h"
#include "keiko/workflow/open_scene.h"

#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// Numbers that a mesh can have at its corners.
enum class SurfaceField {
    k1,       ///< 1/mm, the larger principal curvature
    k2,       ///< 1/mm, the smaller one
    mean,     ///< 1/mm, mean curvature
    gauss,    ///< 1/mm2, Gaussian curvature
    absolute, ///< 1/mm, sum of the sizes of the principal curvatures
    draft,    ///< degrees, draft angle against the pull
    deviation ///< mm, signed distance from another body: positive outside of it
};

/// All of them, in the order of their declaration.
const std::vector<SurfaceField>& every_surface_field();
/// "k1", "k2", "mean", "gauss", "absolute", "draft", "deviation"
std::string_view name_of(SurfaceField field);
/// Throws Error for a name that is no field, listing those there are.
SurfaceField surface_field_by_name(std::string_view name);

/// Makers of triangles.
enum class Mesher {
    opencascade, ///< OpenCASCADE's, each face by itself, measured: as viewports of CAD systems
    spans        ///< a grid in each knot span, within proved bounds
};

/// "opencascade", "spans". Throws FieldError for another name.
Mesher mesher_by_name(std::string_view name);

/// Normals at the corners of a mesh.
enum class CornerNormals {
    surface, ///< those of the exact surface
    averaged ///< the mean of those of the triangles around, within each face
};

/// "surface", "averaged". Throws FieldError for another name.
CornerNormals corner_normals_by_name(std::string_view name);

/// Options of surface_mesh.
struct MeshOptions {
    double deviation = 0.1;             ///< mm that the surface may leave the triangles by; above 0
    std::vector<SurfaceField> fields{}; ///< the first one gives the colours
    Vec3 pull{0, 0, 1};                 ///< of draft; finite, not 0
    const Scene* against = nullptr;     ///< the body that `deviation` is measured from
    double reach = 0;                   ///< mm, of that; 0: a fiftieth of its size
    LoadOptions load{};                 ///< of the worker that makes the triangles
    Mesher mesher = Mesher::opencascade;            ///< that makes them
    CornerNormals normals = CornerNormals::surface; ///< at the corners
    TriangleLimit limit{};                          ///< of the mesher `spans`
};

/// Triangles of a scene's body. Their corners lie on the exact surface, where normals and fields
/// are evaluated: curvatures are positive where it bends towards its outward normal, and no number
/// at poles. A deviation beyond the reach is no number. Faces that no triangles come of are named
/// in lost_faces. Throws Error for options that are out of range, for more triangles than the
/// limit, and as load_model does; Cancelled.
SurfaceMesh surface_mesh(const Scene& scene, const MeshOptions& options = {}, const Job& job = {});

} // namespace keiko
