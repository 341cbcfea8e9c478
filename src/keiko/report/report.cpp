#include "keiko/report/report.h"

#include "keiko/base/error.h"
#include "keiko/base/output_file.h"
#include "keiko/report/report_html.h"
#include "keiko/report/report_json.h"

#include <algorithm>

namespace keiko {
namespace fs = std::filesystem;

Verdict verdict_of(const Report& report) {
    const Verdict seams = report.inspection.verdict;
    return report.lines ? std::max(seams, verdict_of(*report.lines)) : seams;
}

void write_report(const fs::path& folder, const Report& report) {
    std::error_code code;
    fs::create_directories(folder, code);
    if (code) throw Error(folder.string(), "", "cannot make the folder: " + code.message());
    for (const auto* pictures : {&report.pictures, &report.line_pictures})
        for (const ReportPicture& picture : *pictures)
            write_text_file(folder / picture.file_name, picture.png);
    for (const SeamPicture& close_up : report.close_ups)
        write_text_file(folder / close_up.picture.file_name, close_up.picture.png);
    write_text_file(folder / "report.json", report_json(report));
    write_text_file(folder / "report.html", report_html(report));
}

} // namespace keiko
