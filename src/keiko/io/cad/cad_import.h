#pragma once

#include "keiko/io/cad/cad_document.h"
#include "keiko/io/model_format.h"
#include "keiko/patch/surface_model.h"

#include <filesystem>
#include <functional>

namespace keiko::cad {

/// Reads a CAD file into OpenCASCADE's shapes. Throws Error naming the file.
CadDocument read_document(const std::filesystem::path& path, ModelFormat format);

/// Converts all faces of a document; those that cannot be are in lost_faces. `progress` gets 0 to
/// 1. Source and format are left empty.
SurfaceModel convert_document(const CadDocument& document,
                              const std::function<void(double)>& progress = {});

/// Reads a CAD file with OpenCASCADE. `progress` gets 0 to 1. Throws Error naming the file when
/// it cannot be read or holds no faces; faces that cannot be converted are in lost_faces.
SurfaceModel import_cad_file(const std::filesystem::path& path, ModelFormat format,
                             const std::function<void(double)>& progress);

} // namespace keiko::cad
