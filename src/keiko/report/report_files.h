#pragma once

#include "keiko/base/output_folder.h"
#include "keiko/report/content/report.h"

namespace keiko {

/// report.html (self-contained), report.json and the pictures.
FolderContent report_files(const Report& report);

} // namespace keiko
