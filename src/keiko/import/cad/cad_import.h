#pragma once

#include "keiko/base/job.h"
#include "keiko/files/model/model_format.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/import/cad/cad_document.h"

#include <filesystem>

namespace keiko::cad {

/// Reads a CAD file into OpenCASCADE's shapes. Throws Error naming the file.
CadDocument read_document(const std::filesystem::path& path, ModelFormat format);

/// Converts all faces of a document; those that cannot be are in lost_faces. Source and format are
/// left empty. Reports progress as "import".
SurfaceModel convert_document(const CadDocument& document, const Job& job = {});

/// Reads a CAD file with OpenCASCADE. Throws Error naming the file when it cannot be read or holds
/// no faces; faces that cannot be converted are in lost_faces. Reports progress as "import".
SurfaceModel import_cad_file(const std::filesystem::path& path, ModelFormat format, const Job& job);

} // namespace keiko::cad
