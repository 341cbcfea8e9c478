#include "keiko/workflow/inspect_scene.h"

#include "keiko/compare/shape/symmetry.h"
#include "keiko/files/scene/rig_file.h"
#include "keiko/film/image_file.h"
#include "keiko/report/content/report.h"
#include "keiko/workflow/analysis_picture.h"
#include "keiko/workflow/find_lines.h"
#include "keiko/workflow/place_scene.h"
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

/// The order of the faults, and the pictures with their markers.
void add_triage(Report& report, const Scene& scene, const InspectResult& result,
                std::span<const NamedView> views, const Job& job) {
    const auto ground =
        scene.surroundings ? std::optional(scene.surroundings->ground) : std::nullopt;
    report.triage = triage(scene.model, scene.tracer, whole_inspection(report), ground, job);
    report.profiles = profiles_of(scene.model, report.inspection, profiled_seams(report), job);
    const std::vector<ShownItem> shown = shown_items(report);
    for (std::size_t i = 0; i < views.size(); ++i)
        report.pictures.push_back(report_picture(views[i].name, result.films[i].second,
                                                 markers_in(scene, shown, views[i].camera)));
}

PictureOptions with_look_layers(PictureOptions options) {
    for (const Aov layer : look_layers())
        if (std::find(options.aovs.begin(), options.aovs.end(), layer) == options.aovs.end())
            options.aovs.push_back(layer);
    return options;
}

PictureOptions without_aovs(PictureOptions options) {
    options.aovs.clear();
    return options;
}

Film with_only(Film film, const std::vector<Aov>& aovs) {
    for (const Aov aov : every_aov())
        if (std::find(aovs.begin(), aovs.end(), aov) == aovs.end()) film.aovs.erase(aov);
    return film;
}

} // namespace

InspectResult inspect_scene(const Scene& scene, const InspectOptions& options, const Job& job) {
    constexpr int automatic_views = 3;
    const std::vector<NamedView> views = choose_views(scene, options.views, automatic_views, job);
    InspectResult result;
    if (options.register_hits) result.hits = register_hits(scene.tracer, scene.model, views, job);
    PlacementOptions placing = options.placement;
    if (!options.rig && !scene.rig)
        placing.mirror =
            placement_mirror(scene.model, cameras_of(views), placing, options.symmetry, job);
    ChosenLights lights = choose_lights(scene, options.rig, views, placing, job);
    result.rig = std::move(lights.rig);
    result.report.tool_version = version();
    if (lights.placement) result.report.coverage = summary_of(scene.model, *lights.placement);
    result.report.inspection = inspect(
        scene.model, limits_in(scene, options.preset, options.scope, job), options.join, job);
    check_symmetry(scene.model, result.report.inspection, job);
    accept_findings(result.report.inspection, options.acceptances);
    result.report.inspection.facts.tracing = trace_facts(scene.tracer.statistics());
    const PictureOptions picture = with_look_layers(options.picture);
    for (const NamedView& view : views)
        result.films.emplace_back(view.name,
                                  render_view(scene, result.rig, view.camera, picture, job));
    result.report.curvature_pictures =
        curvature_pictures(views, result.films, result.report.inspection);
    add_lines(result.report, scene, result, options, views, job);
    add_triage(result.report, scene, result, views, job);
    if (has_curves(options.combs)) {
        result.combs = combs_of(scene.model, options.combs, job);
        result.report.combs = result.combs->pictures;
        result.report.comb_remarks = result.combs->remarks;
    }
    result.report.close_ups =
        close_ups(scene, result.rig, result.report, views, without_aovs(options.picture), job);
    result.aovs = options.picture.aovs;
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
    if (result.combs)
        files["combs.json"] = result.combs->json, files["combs.csv"] = result.combs->csv;
    return files;
}

} // namespace keiko
