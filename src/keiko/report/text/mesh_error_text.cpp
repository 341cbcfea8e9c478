#include "keiko/base/text.h"
#include "keiko/report/content/mesh_error.h"
#include "keiko/report/markup/html_text.h"

namespace keiko {

double wrong_share(const MeshErrorReport& report, std::size_t mesh) {
    std::size_t wrong = 0, compared = 0;
    for (const MeshErrorView& view : report.views) {
        wrong += view.meshes[mesh].errors.wrong;
        compared += view.meshes[mesh].errors.compared;
    }
    return compared > 0 ? static_cast<double>(wrong) / static_cast<double>(compared) : 0;
}

std::string mesh_error_text(const MeshErrorReport& report) {
    TextLines lines;
    for (std::size_t m = 0; m < report.meshes.size(); ++m) {
        const ComparedMesh& mesh = report.meshes[m];
        lines.line() << "mesh of " << short_number(mesh.asked)
                     << " mm: " << counted(mesh.triangles, "triangle") << ", within "
                     << short_number(mesh.deviation) << " mm; "
                     << fixed_number(100 * wrong_share(report, m), 2)
                     << " % of the mirrored pixels wrong";
        for (const MeshErrorView& view : report.views) {
            const MeshErrors& e = view.meshes[m].errors;
            lines.line() << "  " << view.name << ": " << e.wrong << " of " << e.compared
                         << " pixels wrong, " << e.reversed
                         << " reversed; 99 % of the lines within " << short_number(e.pixels.p99)
                         << " px, " << short_number(e.on_part.p99) << " mm; " << e.missed.all
                         << " pixels missed, " << e.missed.inside << " of them inside";
        }
    }
    return lines.text();
}

} // namespace keiko
