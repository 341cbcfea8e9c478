#include "keiko/workflow/draw_scene.h"

#include "keiko/base/error.h"
#include "keiko/base/job_steps.h"
#include "keiko/base/text.h"
#include "keiko/drawing/line_body.h"
#include "keiko/drawing/sheet/sheet_layout.h"
#include "keiko/export/sheet_files.h"
#include "keiko/geometry/trim/material_bounds.h"
#include "keiko/inspect/combs/comb_curves.h"
#include "keiko/workflow/choose_views.h"
#include "keiko/workflow/find_lines.h"
#include "keiko/workflow/three_views.h"

#include <sstream>

namespace keiko {
namespace {

/// Sections and iso-curves as curves of a drawing.
std::vector<ModelCurve> requested_curves(const SurfaceModel& model, CombOptions options,
                                         double chord_error, const Job& job) {
    std::vector<ModelCurve> curves;
    if (!has_curves(options)) return curves;
    options.chord_error = chord_error;
    for (const CombCurve& found : comb_curves(model, options, job).curves)
        for (const CombPiece& piece : found.pieces) {
            if (piece.samples.size() < 2) continue;
            ModelCurve curve{found.kind == CombCurve::Kind::section ? CurveKind::section
                                                                    : CurveKind::iso};
            for (const CombSample& sample : piece.samples)
                curve.course.points.push_back(sample.place);
            curve.faces = {{piece.instance, piece.face}};
            curve.reach = chord_error;
            curves.push_back(std::move(curve));
        }
    return curves;
}

std::vector<Check> findings_of(const Scene& scene, const CriteriaPreset& preset, double join,
                               const Job& job) {
    CheckOptions check;
    check.preset = preset, check.join = join;
    return check_body(scene.model, check, job).inspection.findings;
}

/// "1 G0 gap 0.12 mm, limit 0.05: face 3 | face 4"
std::vector<std::string> numbered_list(std::span<const Check> findings) {
    std::vector<std::string> lines;
    for (const Check& check : findings) {
        std::ostringstream line;
        line.precision(3);
        line << lines.size() + 1 << "  " << check.quantity << ' ' << check.worst.value << ' '
             << check.unit << ", limit " << check.worst.limit << ": " << check.faces;
        lines.push_back(line.str());
    }
    return lines;
}

/// One view on its way to the sheet.
class ViewDrawer {
public:
    ViewDrawer(const Scene& scene, const DrawOptions& options, const LineBody& body)
        : scene_(scene), options_(options), body_(body) {}

    SheetView run(const NamedView& view, std::vector<ModelCurve> others,
                  std::span<const Check> findings, const Job& job) const {
        Camera camera = view.camera;
        if (!options_.perspective) camera.projection = Projection::orthographic;
        if (options_.rig)
            for (ModelCurve& line : lines(camera, job)) others.push_back(std::move(line));
        const bool wireframe = options_.hidden == HiddenLines::draw;
        SheetView drawn{view.name, {}, !options_.perspective};
        drawn.strokes = body_.strokes(camera, others, wireframe, job);
        std::vector<Vec3> places;
        for (const Check& check : findings) places.push_back(check.worst.place);
        drawn.marks = marks_at(places, body_, camera, wireframe);
        return drawn;
    }

private:
    std::vector<ModelCurve> lines(const Camera& camera, const Job& job) const {
        SurfaceLineOptions search;
        search.look = options_.look;
        search.lines.chord_error = body_.chord_error();
        const std::vector<LineSource> sources = line_sources(*options_.rig, options_.look);
        std::vector<ModelCurve> curves;
        for (const SurfaceLine& line :
             surface_lines(scene_.model, scene_.seen(), sources, camera, search, job)) {
            ModelCurve curve{CurveKind::line};
            for (const LinePoint& point : line.line.points)
                curve.course.points.push_back(point.place);
            curve.faces = {{line.instance, line.face}};
            curve.reach = body_.chord_error();
            curves.push_back(std::move(curve));
        }
        return curves;
    }

    const Scene& scene_;
    const DrawOptions& options_;
    const LineBody& body_;
};

/// "left.step, right.step"
std::string names_of(std::span<const std::filesystem::path> files) {
    std::vector<std::string> names;
    for (const std::filesystem::path& file : files) names.push_back(file.filename().string());
    return comma_list(names);
}

} // namespace

Vec2 paper_size(std::string_view name) {
    if (name == "A4") return {297, 210};
    if (name == "A3") return {420, 297};
    if (name == "A2") return {594, 420};
    if (name == "A1") return {841, 594};
    if (name == "A0") return {1189, 841};
    throw Error("", "paper '" + std::string(name) + "'", "is not one of A4, A3, A2, A1 and A0");
}

Sheet draw_scene(const Scene& scene, const DrawOptions& options, const Job& job) {
    if (options.rig && !has_lines(*options.rig, options.look))
        throw Error("", "rig", "it has no lamps whose lines could be drawn");
    const bool three = options.views.empty();
    const std::vector<NamedView> views =
        choose_views(scene, three ? three_views() : options.views, 1, job);
    require_different_names(views);
    constexpr double judging = 4, finding = 1, drawing = 2;
    JobSteps steps(job, (options.findings ? judging : 0) + finding +
                            drawing * static_cast<double>(views.size()));
    const std::vector<Check> findings = options.findings
                                            ? findings_of(scene, *options.findings, options.join,
                                                          steps.next(judging, inspection_stages))
                                            : std::vector<Check>();
    const Job first = steps.next(finding, 2);
    const LineBody body(scene.model, scene.tracer,
                        {.join = options.join, .crease_angle = options.crease_angle}, first);
    const std::vector<ModelCurve> others =
        requested_curves(scene.model, options.curves, body.chord_error(), first);
    const Box3 box = material_bounds(scene.model);
    const ViewDrawer drawer(scene, options, body);
    std::vector<SheetView> drawn;
    for (const NamedView& view : views) {
        drawn.push_back(drawer.run(view, others, findings, steps.next(drawing, 2, view.name)));
        if (!options.perspective) add_dimensions(drawn.back(), view.camera, box);
    }
    if (three && !options.perspective)
        drawn[1].height = drawn[2].width = std::nullopt; // as in the first view
    SheetOptions layout;
    layout.paper = options.paper, layout.without = options.without;
    layout.dash_hidden = options.hidden == HiddenLines::dash;
    layout.three_views = three && !options.perspective;
    layout.list = numbered_list(findings);
    layout.title = options.title.empty() ? names_of(scene.inputs) : options.title;
    return laid_out(drawn, layout);
}

bool is_sheet_output(const std::filesystem::path& path) {
    const std::string ending = lower_case(path.extension().string());
    return ending == ".svg" || ending == ".dxf" || ending == ".pdf";
}

std::string sheet_output(const Sheet& sheet, const std::filesystem::path& path) {
    const std::string ending = lower_case(path.extension().string());
    if (ending == ".svg") return svg_sheet(sheet);
    if (ending == ".dxf") return dxf_sheet(sheet);
    if (ending == ".pdf") return pdf_sheet(sheet);
    throw Error(path.string(), "", "is no drawing: its name does not end in .svg, .dxf or .pdf");
}

} // namespace keiko
