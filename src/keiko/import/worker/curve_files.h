#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/model/curve_set.h"
#include "keiko/import/worker/load_model.h"

#include <filesystem>
#include <string>

namespace KEIKO_API keiko {

/// True if a file's name ends in .step, .stp, .iges or .igs: a file of curves can be written there.
bool is_curve_file(const std::filesystem::path& path);

/// Bytes of a STEP or IGES file of curves, by the ending of `path`: B-splines in mm, with names and
/// colours. The worker process of load_model makes them. Throws Error naming `path` for another
/// ending and as load_model does.
std::string curve_file(const CurveSet& set, const std::filesystem::path& path,
                       const LoadOptions& options = {}, const Job& job = {});

/// The free curves of a STEP or IGES file, mm: those that bound no face, each shape of the file a
/// curve with the name and the colour that it has there. Deviations are not in such a file, and 0.
/// Throws Error when it holds none and as load_model does.
CurveSet read_curves(const std::filesystem::path& path, const LoadOptions& options = {},
                     const Job& job = {});

} // namespace keiko
