#include "keiko/workflow/inspect_scene.h"

#include "keiko/base/job_steps.h"
#include "keiko/files/scene/rig_file.h"
#include "keiko/film/image_file.h"
#include "keiko/film/tone_mapping.h"
#include "keiko/light/rig/body_lamps.h"
#include "keiko/report/content/report.h"
#include "keiko/report/content/triaged_faults.h"
#include "keiko/workflow/analysis_file.h"
#include "keiko/workflow/analysis_picture.h"
#include "keiko/workflow/close_ups.h"
#include "keiko/workflow/find_lines.h"
#include "keiko/workflow/hidden_faces.h"
#include "keiko/workflow/judged_body.h"
#include "keiko/workflow/place_scene.h"
#include "keiko/workflow/report_drawing.h"
#include "keiko/workflow/report_pictures.h"
#include "keiko/workflow/version.h"
#include "keiko/workflow/zoned_limits.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace keiko {
namespace {

std::string percent(double share) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.1f %%", 100 * share);
    return text.data();
}

CoverageSummary summary_of(const SurfaceModel& model, const Placement& placement) {
    CoverageSummary summary{"rig.toml", placement.coverage, {}};
    for (const FaceCoverage& face : placement.faces) {
        constexpr double reached_enough = 0.5, worth_telling = 0.005;
        if (face.reached >= reached_enough || face.share < worth_telling) continue;
        summary.unreached.push_back(model.describe(model.faces[face.face]) + ": " +
                                    percent(face.reached) + " of it reached, " +
                                    percent(face.share) + " of the pictures");
    }
    return summary;
}

ReportPicture picture_of_lines(const std::string& view, const Image& drawn) {
    return {.title = view,
            .caption = "",
            .file_name = view + "-lines.png",
            .png = encode_png(drawn),
            .width = drawn.width,
            .height = drawn.height,
            .markers = {}};
}

void add_lines(Report& report, const Scene& scene, const InspectResult& result,
               const InspectOptions& options, std::span<const NamedView> views, const Job& job) {
    if (!has_lines(result.rig)) return;
    LinesOptions asked;
    asked.preset = options.preset;
    asked.join = options.join;
    report.lines =
        lines_under(scene, result.rig, views, asked, result.report.inspection.limits, job);
    report.lines->acceptances = options.acceptances;
    for (std::size_t i = 0; i < views.size(); ++i)
        report.line_pictures.push_back(
            picture_of_lines(views[i].name, with_lines(result.films[i].second, *report.lines, i)));
}

/// The first stretches, without those that pass.
std::vector<std::uint32_t> profiled_seams(const Report& report) {
    std::vector<std::uint32_t> seams = first_seams(report, most_profiles);
    std::erase_if(seams, [&](std::uint32_t seam) {
        return report.inspection.seams[seam].verdict == Verdict::pass;
    });
    return seams;
}

/// The order of the faults, and the pictures of the part that is shown with their markers.
void add_triage(Report& report, const Scene& scene, const Scene& part, const InspectResult& result,
                std::span<const NamedView> views, const Job& job) {
    report.triage =
        triage(scene.model, scene.tracer, whole_inspection(report), scene.ground(), job);
    report.profiles = profiles_of(scene.model, report.inspection, profiled_seams(report), job);
    const std::vector<ShownItem> shown = shown_items(report);
    for (std::size_t i = 0; i < views.size(); ++i)
        report.pictures.push_back(report_picture(views[i].name, tone_mapped(result.films[i].second),
                                                 markers_in(part, shown, views[i].camera)));
}

PictureOptions with_look_layers(PictureOptions options) {
    for (const Aov layer : look_layers(AnalysisMode::gauss))
        if (std::find(options.aovs.begin(), options.aovs.end(), layer) == options.aovs.end())
            options.aovs.push_back(layer);
    return options;
}

PictureOptions without_aovs(PictureOptions options) {
    options.aovs.clear();
    return options;
}

/// Shares of the time of an inspection, as on the concept car and the hood of `surfaces`.
struct InspectWeights {
    static constexpr double choosing = 1.5, registering = 1, placing = 3, limiting = 0.5,
                            picture = 2.5, lines = 3, triage = 1, standing = 1, combs = 1,
                            close_ups = 3, drawing = 0.5;
};

constexpr int automatic_views = 3;

JudgedParts parts_of(const InspectOptions& options) {
    return {options.join, options.joints, options.acceptances};
}

/// The requested curves, and the sections of the scene's analysis.
CombOptions combs_with_sections(const Scene& scene, CombOptions combs) {
    if (!scene.analysis) return combs;
    for (const std::string& section : scene.analysis->analysis.sections)
        if (std::none_of(combs.planes.begin(), combs.planes.end(),
                         [&](const SectionPlane& plane) { return plane.name == section; }))
            combs.planes.push_back(section_plane(section));
    return combs;
}

double views_of(const Scene& scene, const InspectOptions& options) {
    if (!options.views.empty()) return static_cast<double>(options.views.size());
    const std::size_t own = scene.analysis ? scene.analysis->analysis.views.size() : 0;
    return own > 0 ? static_cast<double>(own) : automatic_views;
}

double weight_of(const Scene& scene, const InspectOptions& options, const CombOptions& combs) {
    using W = InspectWeights;
    const double views = views_of(scene, options);
    return W::choosing + W::placing + W::limiting + parts_of(options).weight() +
           (W::picture + W::lines) * views + W::triage + W::standing + W::close_ups + W::drawing +
           (options.register_hits ? W::registering : 0) + (has_curves(combs) ? W::combs : 0);
}

Film with_only(Film film, const std::vector<Aov>& aovs) {
    for (const Aov aov : every_aov())
        if (std::find(aovs.begin(), aovs.end(), aov) == aovs.end()) film.aovs.erase(aov);
    return film;
}

std::vector<InputFile> inputs_of(const Scene& scene, const InspectOptions& options) {
    std::vector<std::filesystem::path> inputs = scene.inputs;
    if (options.rig) inputs.push_back(*options.rig);
    for (const std::filesystem::path view : options.views)
        if (view.extension() == ".toml") inputs.push_back(view);
    if (scene.analysis && !scene.analysis->analysis.file.empty())
        inputs.emplace_back(scene.analysis->analysis.file);
    inputs.insert(inputs.end(), options.settings.begin(), options.settings.end());
    return input_files(inputs);
}

/// The lamps of an inspection: given, of the scene, or placed.
void choose_rig(const Scene& scene, const InspectOptions& options, std::span<const NamedView> views,
                InspectResult& result, const Job& job) {
    PlacementOptions placing = options.placement;
    // Surroundings light a scene, but reflection lines need lamps.
    const bool places = !options.rig && (!scene.rig || shines_by_bodies_alone(*scene.rig));
    if (places)
        placing.mirror =
            placement_mirror(scene.model, cameras_of(views), placing, options.symmetry, job);
    ChosenLights lights;
    if (places) {
        lights.placement = place_lamps(scene.tracer, scene.model, cameras_of(views), placing, job);
        lights.rig = lights.placement->rig;
        add_body_lamps(scene.rig, lights.rig);
    } else {
        lights = choose_lights(scene, options.rig, views, placing, job);
    }
    result.rig = std::move(lights.rig);
    if (lights.placement) result.report.coverage = summary_of(scene.model, *lights.placement);
}

Inspection measured(const Scene& scene, const InspectOptions& options, JobSteps& steps) {
    const FaceLimits limits =
        limits_in(scene, options.preset, options.scope, steps.next(InspectWeights::limiting));
    Inspection found = judged_body(scene.model, limits, parts_of(options), steps);
    found.facts.tracing = trace_facts(scene.tracer.statistics());
    return found;
}

void render_views(const Scene& scene, const InspectOptions& options,
                  std::span<const NamedView> views, InspectResult& result, JobSteps& steps) {
    const PictureOptions picture = with_look_layers(options.picture);
    // Requested layers may hold numbers of light, which keep the same share everywhere.
    const auto render = options.picture.aovs.empty() ? render_to_show : render_view;
    for (const NamedView& view : views)
        result.films.emplace_back(view.name,
                                  render(scene, result.rig, view.camera, picture,
                                         steps.next(InspectWeights::picture, 1, view.name)));
}

} // namespace

InspectResult inspect_scene(const Scene& scene, const InspectOptions& options, const Job& job) {
    const CombOptions combs = combs_with_sections(scene, options.combs);
    JobSteps steps(job, weight_of(scene, options, combs));
    const std::vector<NamedView> views =
        choose_views(scene, options.views, automatic_views, steps.next(InspectWeights::choosing));
    InspectResult result;
    result.report.tool_version = version();
    result.report.inputs = inputs_of(scene, options);
    for (const auto& file : scene.inputs) result.report.opened.push_back(file.string());
    result.report.views = views;
    if (options.register_hits)
        result.hits = register_hits(scene.tracer, scene.model, views,
                                    steps.next(InspectWeights::registering));
    choose_rig(scene, options, views, result, steps.next(InspectWeights::placing, 3));
    result.report.inspection = measured(scene, options, steps);
    const std::optional<Scene> part = without_hidden_faces(scene, job);
    const Scene& shown = part ? *part : scene;
    render_views(shown, options, views, result, steps);
    result.report.curvature_pictures =
        curvature_pictures(views, result.films, result.report.inspection);
    add_lines(result.report, shown, result, options, views,
              steps.next_of_steps(InspectWeights::lines * static_cast<double>(views.size())));
    add_triage(result.report, scene, shown, result, views, steps.next(InspectWeights::triage, 2));
    result.report.standing_pictures =
        standing_pictures(shown, result.report, steps.next_of_steps(InspectWeights::standing));
    result.report.drawing =
        report_drawing(shown, whole_inspection(result.report).findings, options.join,
                       steps.next_of_steps(InspectWeights::drawing));
    if (has_curves(combs)) {
        result.combs = combs_of(scene.model, combs, steps.next(InspectWeights::combs));
        result.report.combs = result.combs->pictures;
        result.report.comb_remarks = result.combs->remarks;
    }
    const int stages = static_cast<int>(std::max<std::size_t>(options.close_ups, 1));
    result.report.close_ups =
        close_ups(shown, result.rig, result.report, views, without_aovs(options.picture),
                  options.close_ups, steps.next(InspectWeights::close_ups, stages, "close-ups"));
    result.aovs = options.picture.aovs;
    if (scene.analysis) {
        result.analysis = scene.analysis->analysis;
        result.report.notes = result.analysis->notes;
    }
    return result;
}

FolderContent result_files(const std::filesystem::path& folder, const InspectResult& result) {
    FolderContent files = report_files(result.report);
    for (std::size_t i = 0; i < result.films.size(); ++i) {
        const auto& [name, film] = result.films[i];
        if (!result.aovs.empty()) files[name + ".exr"] = encode_exr(with_only(film, result.aovs));
        files[name + "-marked.png"] =
            encode_png(marked_image(film, result.report.pictures[i].markers));
    }
    files["rig.toml"] = rig_text(result.rig, folder);
    if (result.analysis) files["analysis.json"] = analysis_text(*result.analysis, folder);
    const Report& report = result.report;
    files["faults.json"] = faults_json({report.triage, report.profiles}, whole_inspection(report),
                                       report.tool_version);
    if (result.combs)
        files["combs.json"] = result.combs->json, files["combs.csv"] = result.combs->csv;
    return files;
}

} // namespace keiko
