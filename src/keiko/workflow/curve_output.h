#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/model/curve_set.h"
#include "keiko/import/worker/load_model.h"

#include <filesystem>
#include <string>

namespace KEIKO_API keiko {

/// True if curves can be written to a file of this name: it ends in .step, .stp, .iges, .igs or
/// .vtp.
bool is_curve_output(const std::filesystem::path& path);

/// Bytes of a file of curves in the format of the ending: B-splines of STEP or IGES as curve_file
/// makes them, or VTK's polylines within 0.001 mm of them. Throws Error as curve_file does.
std::string curve_output(const CurveSet& set, const std::filesystem::path& path,
                         const LoadOptions& options = {}, const Job& job = {});

} // namespace keiko
