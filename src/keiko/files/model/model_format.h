#pragma once

#include "keiko/base/export.h"

#include <filesystem>
#include <string_view>

namespace KEIKO_API keiko {

/// Kinds of model files, distinguished by their content, never by their name.
enum class ModelFormat {
    step,   ///< [ISO10303-21]
    iges,   ///< 80-column IGES
    brep,   ///< OpenCASCADE's text BREP
    bezier, ///< .bpt: a count, then degrees and control points of each patch
    cage,   ///< OBJ: vertices and faces, the cage of a subdivision surface
    teapot  ///< the classic teapot text: a count, index lists, a count, vertices
};

/// "STEP", "IGES", "BREP", "BPT", "OBJ", "teapot text".
std::string_view name_of(ModelFormat format);

/// Throws Error when the file cannot be read, or is of no kind that Keiko knows, or is cut short
/// (STEP, IGES and BREP say where they end).
ModelFormat detect_model_format(const std::filesystem::path& path);

} // namespace keiko
