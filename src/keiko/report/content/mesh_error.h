#pragma once

#include "keiko/base/export.h"
#include "keiko/base/output_folder.h"
#include "keiko/raster/mesh_errors.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace KEIKO_API keiko {

/// A mesh whose reflections are compared with those of the surface.
struct ComparedMesh {
    double asked = 0;                    ///< mm, deviation that was requested
    double deviation = 0;                ///< mm, largest of the surface from the triangles
    std::size_t triangles = 0;           ///< number of them
    std::vector<std::string> lost_faces; ///< a line for each face without triangles
};

/// A mesh in one view.
struct MeshErrorPictures {
    MeshErrors errors{};    ///< of its reflections
    FacetBands bands{};     ///< at borders of its facets
    std::string mirror{};   ///< name of the PNG of its mirrored lamps
    std::string wrong{};    ///< name of the PNG of the pixels that are wrong
    std::string close_up{}; ///< of its mirrored lamps at the close-up; empty if there is none
};

/// A view, with the meshes in the order of MeshErrorReport::meshes. It has close-ups of the place
/// where the mesh of the largest wanted deviation mirrors lamps wrong most, if it does anywhere.
struct MeshErrorView {
    std::string name;          ///< of the view
    int width = 0, height = 0; ///< pixels of the pictures
    std::string truth{};       ///< name of the PNG of the lamps that the surface mirrors
    std::string close_up{};    ///< the same at the close-up; empty if there is none
    int close_up_side = 0;     ///< pixels of a side of the close-ups
    double magnification = 0;  ///< of the close-ups
    std::vector<MeshErrorPictures> meshes{}; ///< one a mesh
};

/// Errors of the reflections of a part in its meshes: for who trusts a viewport.
struct MeshErrorReport {
    std::string tool_version;           ///< version of Keiko that compared
    std::string source;                 ///< files of the part
    std::string lamps;                  ///< where the lamps are from
    bool averaged_normals = false;      ///< corners have the mean normals of triangles around them
    bool proved = false;                ///< deviations are bounds; otherwise they are measured
    std::vector<ComparedMesh> meshes{}; ///< in the order of the requests
    std::vector<MeshErrorView> views{}; ///< in order
    FolderContent pngs{};               ///< that the views name
};

/// Share of the compared pixels that are wrong, over all views; nullopt without any.
std::optional<double> wrong_share(const MeshErrorReport& report, std::size_t mesh);
/// "12.30 % of the mirrored pixels wrong; 5 pixels missed, 2 added, 0 of another face", or that no
/// pixel mirrors the lamps.
std::string mesh_error_head(const MeshErrorReport& report, std::size_t mesh);

/// The errors for people, a line a mesh and view.
std::string mesh_error_text(const MeshErrorReport& report);
/// The errors as "keiko-mesh-error/1"; see docs/file-formats.md. It holds no times: every run gives
/// the same bytes.
std::string mesh_error_json(const MeshErrorReport& report);
/// The errors as a self-contained page, pictures included.
std::string mesh_error_html(const MeshErrorReport& report);

} // namespace keiko
