#pragma once

#include "shape_pool.h"

#include <filesystem>

namespace keiko::fixtures {

/// Writes one body as STEP AP214 in mm: a shell for each connected part, each face an
/// ADVANCED_FACE with its name.
/// The file depends on the faces alone, not on date, user or machine. Throws std::runtime_error if
/// BRepCheck finds a fault.
void write_step(const std::filesystem::path& file, const std::vector<NamedFace>& faces);

} // namespace keiko::fixtures
