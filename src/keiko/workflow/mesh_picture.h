#pragma once

#include "keiko/base/export.h"
#include "keiko/film/film.h"
#include "keiko/raster/shading_rule.h"
#include "keiko/workflow/open_scene.h"
#include "keiko/workflow/surface_mesh.h"

#include <optional>
#include <string>

namespace KEIKO_API keiko {

/// The shading of a look "mesh:constant", "mesh:gouraud" or "mesh:phong"; nullopt for a look that
/// is none of meshes. Throws FieldError for another kind of mesh.
std::optional<MeshShading> mesh_shading_from(const std::string& look);

/// Options of mesh_film.
struct MeshLook {
    MeshShading shading = MeshShading::phong;                  ///< of its triangles
    HiddenSurfaces hidden_surfaces = HiddenSurfaces::z_buffer; ///< the way to find them
    MeshShadows shadows = MeshShadows::none;                   ///< the way to find them
    MeshOptions mesh{};                                        ///< its deviation, maker and loading
    bool by_pixels = false; ///< facets of a pixel of the exact patches take the mesh's place
};

/// Picture of a mesh of a scene's body under a rig, where everything else of the picture is exact:
/// the luminance of its pixels' centres, without what the body mirrors of itself. Beside the mesh
/// the ground, the sky and the background are seen. Lamps before it are not. With `shadows` the
/// mesh dims the lights of mesh_light_shares() on what the eye sees of it and of the ground, by
/// pixels of the mesh itself. `by_pixels` needs no mesh: it has no shadows, as facets are made of
/// what is seen alone, and recursive subdivision finds that [Catmull1974]. Throws as surface_mesh,
/// FieldError for `shadows` or another way than the z-buffer with `by_pixels` and for a scene with
/// fog, maps, brushed metal or bodies that emit light, and Cancelled.
Film mesh_film(const Scene& scene, const LightRig& rig, const Camera& camera,
               const MeshLook& look = {}, const Job& job = {});

} // namespace keiko
