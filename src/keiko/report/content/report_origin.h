#pragma once

#include "keiko/report/content/report.h"

#include <string>
#include <vector>

namespace keiko {

/// The files and views that a report in JSON rests on.
struct ReportOrigin {
    std::vector<InputFile> inputs;   ///< as in Report
    std::vector<std::string> opened; ///< as in Report; never empty
    std::vector<NamedView> views;    ///< as in Report; never empty
};

/// The origin of a report in JSON (keiko-report/1). Throws Error naming `file` for any other text.
ReportOrigin report_origin_from_json(const std::string& text, const std::string& file);

/// Throws Error naming `file` unless a text is faults in JSON (keiko-faults/1), each with a place.
void require_faults_json(const std::string& text, const std::string& file);

} // namespace keiko
