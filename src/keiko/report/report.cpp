#include "keiko/report/report.h"

#include "keiko/report/report_html.h"
#include "keiko/report/report_json.h"

#include <algorithm>

namespace keiko {

Verdict verdict_of(const Report& report) {
    const Verdict seams = report.inspection.verdict;
    return report.lines ? std::max(seams, verdict_of(*report.lines)) : seams;
}

FolderContent report_files(const Report& report) {
    FolderContent files;
    for (const auto* pictures : {&report.pictures, &report.line_pictures, &report.form_pictures})
        for (const ReportPicture& picture : *pictures) files[picture.file_name] = picture.png;
    for (const CloseUp& close_up : report.close_ups)
        files[close_up.picture.file_name] = close_up.picture.png;
    for (const CombPicture& picture : report.combs) files[picture.file_name()] = picture.svg;
    files["report.json"] = report_json(report);
    files["report.html"] = report_html(report);
    return files;
}

} // namespace keiko
