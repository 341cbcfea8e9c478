#pragma once

#include "keiko/base/error.h"
#include "keiko/base/export.h"
#include "keiko/placement/best_view.h"

#include <filesystem>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// The folder of an inspection, as far as it is needed to open the inspected body again.
struct ReportFolder {
    std::vector<std::filesystem::path> inputs; ///< the models in order, or the scene file
    std::vector<NamedView> views;              ///< of its pictures, at least one
    std::filesystem::path rig;                 ///< the file with its lamps
    std::filesystem::path analysis;            ///< the file with its analysis; empty: none
    std::string report;                        ///< text of report.json
    std::string faults;                        ///< text of faults.json
    Diagnostics changes; ///< input files that are missing, or have other bytes than then
};

/// True if the path is a folder with a report.json.
bool is_report_folder(const std::filesystem::path& path);

/// Reads the folder that an inspection wrote. Paths in it are relative to the working directory of
/// the inspection, or absolute. Throws Error naming the file and the key that cannot be read.
ReportFolder read_report_folder(const std::filesystem::path& folder);

} // namespace keiko
