#pragma once

#include "keiko/base/export.h"
#include "keiko/report/content/mesh_error.h"
#include "keiko/workflow/place_scene.h"
#include "keiko/workflow/surface_mesh.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// Options of mesh_error.
struct MeshErrorOptions {
    std::vector<double> deviations{1, 0.1};           ///< mm, of the meshes; above 0, each but once
    std::vector<std::string> views{};                 ///< names; empty: three automatic ones
    std::optional<std::filesystem::path> rig{};       ///< none: the scene's own, or else placed
    PlacementOptions placement{};                     ///< of lamps that are placed
    Mesher mesher = Mesher::opencascade;              ///< that makes the meshes
    CornerNormals normals = CornerNormals::surface;   ///< of the meshes
    LoadOptions load{};                               ///< of the worker that makes the triangles
    std::size_t most_triangles = most_span_triangles; ///< of all meshes together, by spans
};

/// Compares what meshes of a scene's body mirror of rows of lamps with what the surface itself
/// mirrors, in views from the same eyes. Neither mirrors the body or casts shadows. Throws Error
/// for options out of range, for more triangles than the most, for an unknown view, and for a rig
/// without rows of tubes; Cancelled.
MeshErrorReport mesh_error(const Scene& scene, const MeshErrorOptions& options = {},
                           const Job& job = {});

/// mesh-error.html, mesh-error.json and the pictures, for a folder.
FolderContent mesh_error_files(const MeshErrorReport& report);

} // namespace keiko
