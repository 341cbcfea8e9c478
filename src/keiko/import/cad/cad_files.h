#pragma once

#include "keiko/import/cad/cad_document.h"

#include <filesystem>

namespace keiko::cad {

/// Each reads one kind of file. Throws Error naming the file when it cannot be read.
CadDocument read_step_file(const std::filesystem::path& path);
CadDocument read_iges_file(const std::filesystem::path& path);
CadDocument read_brep_file(const std::filesystem::path& path);

} // namespace keiko::cad
