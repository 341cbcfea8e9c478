#include "keiko/base/text.h"
#include "keiko/report/content/mesh_error.h"
#include "keiko/report/markup/html_text.h"

namespace keiko {

namespace {

/// Sum of a number of pixels over all views; `of`(errors) is that of one.
template <class Of>
std::size_t pixels_of(const MeshErrorReport& report, std::size_t mesh, const Of& of) {
    std::size_t sum = 0;
    for (const MeshErrorView& view : report.views) sum += of(view.meshes[mesh].errors);
    return sum;
}

} // namespace

std::optional<double> wrong_share(const MeshErrorReport& report, std::size_t mesh) {
    const auto wrong = pixels_of(report, mesh, [](const MeshErrors& e) { return e.wrong; });
    const auto compared = pixels_of(report, mesh, [](const MeshErrors& e) { return e.compared; });
    if (compared == 0) return std::nullopt;
    return static_cast<double>(wrong) / static_cast<double>(compared);
}

std::string mesh_error_head(const MeshErrorReport& report, std::size_t mesh) {
    const std::optional<double> share = wrong_share(report, mesh);
    const auto missed = pixels_of(report, mesh, [](const MeshErrors& e) { return e.missed.all; });
    const auto added = pixels_of(report, mesh, [](const MeshErrors& e) { return e.added.all; });
    const auto other =
        pixels_of(report, mesh, [](const MeshErrors& e) { return e.other_face.all; });
    return (share ? fixed_number(100 * *share, 2) + " % of the mirrored pixels wrong"
                  : "no pixel mirrors the lamps") +
           "; " + counted(missed, "pixel") + " missed, " + std::to_string(added) + " added, " +
           std::to_string(other) + " of another face";
}

std::string mesh_error_text(const MeshErrorReport& report) {
    TextLines lines;
    for (std::size_t m = 0; m < report.meshes.size(); ++m) {
        const ComparedMesh& mesh = report.meshes[m];
        lines.line() << "mesh of " << short_number(mesh.asked)
                     << " mm: " << counted(mesh.triangles, "triangle") << ", within "
                     << short_number(mesh.deviation) << " mm; " << mesh_error_head(report, m);
        for (const MeshErrorView& view : report.views) {
            const MeshErrors& e = view.meshes[m].errors;
            lines.line() << "  " << view.name << ": " << e.wrong << " of " << e.compared
                         << " pixels wrong, " << e.reversed
                         << " reversed; 99 % of the lines within " << short_number(e.pixels.p99)
                         << " px, " << short_number(e.on_part.p99) << " mm; "
                         << counted(e.missed.all, "pixel") << " missed, " << e.missed.inside
                         << " of them inside";
        }
    }
    return lines.text();
}

} // namespace keiko
