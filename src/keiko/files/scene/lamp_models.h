#pragma once

#include "keiko/light/tubes/c_plane.h"

#include <string_view>

namespace keiko {

class TomlTable;

/// Reads what a row of lamps is taken for into the plane: `fidelity`, which stands for both of
/// `diffuse` and `mirror`, and these. Throws Error with file, line and column.
void take_lamp_models(const TomlTable& table, CPlane& plane);

/// The word of a rig file for a model, which no file has for TubeModel::picture and preview: then
/// Error.
std::string_view word_of(TubeModel model);
std::string_view word_of(MirrorModel look);

} // namespace keiko
