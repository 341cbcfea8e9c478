#pragma once

#include "keiko/geometry/model/model_mesh.h"

#include <string>
#include <string_view>

namespace keiko {

/// Bytes of a mesh, for the worker: its numbers little-endian, texts after their lengths.
std::string serialize(const ModelMesh& mesh);

/// The mesh in `bytes`. Throws Error naming `file` when they are damaged, or hold a number that is
/// not finite or the index of no corner.
ModelMesh deserialize_mesh(std::string_view bytes, const std::string& file);

} // namespace keiko
