#include "keiko/report/report_files.h"

#include "keiko/report/html/report_html.h"
#include "keiko/report/json/report_json.h"

#include <algorithm>

namespace keiko {

FolderContent report_files(const Report& report) {
    FolderContent files;
    for (const auto* pictures :
         {&report.pictures, &report.line_pictures, &report.curvature_pictures})
        for (const ReportPicture& picture : *pictures) files[picture.file_name] = picture.png;
    for (const CloseUp& close_up : report.close_ups)
        files[close_up.picture.file_name] = close_up.picture.png;
    for (const CombPicture& picture : report.combs) files[picture.file_name()] = picture.svg;
    files["report.json"] = report_json(report);
    files["report.html"] = report_html(report);
    return files;
}

} // namespace keiko
