#include "keiko/regress/run_fixture.h"

#include "keiko/base/error.h"
#include "keiko/compare/body_metrics.h"
#include "keiko/files/scene/rig_file.h"
#include "keiko/files/scene/scene_file.h"
#include "keiko/film/image_file.h"
#include "keiko/placement/place_lamps.h"
#include "keiko/report/record_files.h"
#include "keiko/workflow/find_lines.h"
#include "keiko/workflow/place_scene.h"
#include "keiko/workflow/version.h"
#include "keiko/workflow/zoned_limits.h"

#include <iterator>

namespace keiko {
namespace fs = std::filesystem;
namespace {

Scene open_fixture(const FixtureSpec& spec, const LoadOptions& load, const Job& job) {
    SceneOptions options{.load = load, .shadows = spec.shadows};
    if (spec.material) options.material = *spec.material;
    Scene scene = open_scene(spec.models, options, job);
    scene.set_picture_size(spec.width, spec.height);
    return scene;
}

/// True for names of views that are framed by what is visible; a camera of a file is what it is.
bool is_framed(const std::string& name) {
    return name != "scene" && !is_view_file(name);
}

/// Names of the views to render; none where the scene has a camera.
std::vector<std::string> asked_views(const Scene& scene, const FixtureSpec& spec) {
    if (!spec.views.empty()) return spec.views;
    if (scene.camera) return {};
    if (scene.view) return {*scene.view};
    throw Error(spec.file.string(), "views", "are missing: the body has no camera of its own");
}

NamedView view_of(const Scene& scene, const std::string& asked, const FixtureSetup& kept,
                  FixtureSetup& setup, const Job& job) {
    if (!is_framed(asked)) return choose_views(scene, {&asked, 1}, 1, job).front();
    if (const FixtureEye* eye = kept.eye(asked, scene.width, scene.height)) {
        setup.eyes.push_back(*eye);
        return {eye->view, eye->camera};
    }
    NamedView view = choose_views(scene, {&asked, 1}, 1, job).front();
    setup.eyes.push_back({asked, view.name, view.camera});
    return view;
}

std::vector<NamedView> views_of(const Scene& scene, const FixtureSpec& spec,
                                const FixtureSetup& kept, FixtureSetup& setup, const Job& job) {
    std::vector<NamedView> views;
    for (const std::string& asked : asked_views(scene, spec))
        views.push_back(view_of(scene, asked, kept, setup, job));
    if (views.empty()) return choose_views(scene, {}, 1, job);
    require_different_names(views);
    return views;
}

void append(std::vector<Metric>& to, std::vector<Metric> more) {
    to.insert(to.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

void measure_geometry(const Scene& scene, const FixtureSpec& spec, FixtureRecord& record,
                      const Job& job) {
    if (!spec.checks.shape && !spec.checks.seams) return;
    const Inspection inspection =
        inspect(scene.model, limits_in(scene, spec.preset, {}, job), spec.join, job);
    if (spec.checks.shape) append(record.metrics, shape_metrics(scene.model, inspection.facts));
    if (spec.checks.seams) append(record.metrics, seam_metrics(inspection));
}

void note_coverage(const Placement& placement, FixtureRecord& record) {
    record.metrics.push_back(
        {"lines", "coverage of the lamps placed", Quantity::share, placement.coverage});
}

/// The lamps that were placed for the body as it once was.
LightRig kept_rig(const Scene& scene, const std::string& text, std::span<const NamedView> views,
                  FixtureRecord& record, const Job& job) {
    LightRig rig = parse_rig(text, "rig.toml of the baseline");
    note_coverage(rated_rig(sample_views(scene.tracer, scene.model, cameras_of(views), {}, job),
                            scene.model, views.front().camera.height, rig),
                  record);
    record.setup.placed_rig = text;
    return rig;
}

LightRig rig_of(const Scene& scene, const FixtureSpec& spec, std::span<const NamedView> views,
                const FixtureSetup& kept, FixtureRecord& record, const Job& job) {
    if (!spec.rig && !scene.rig && !kept.placed_rig.empty())
        return kept_rig(scene, kept.placed_rig, views, record, job);
    ChosenLights lights = choose_lights(scene, spec.rig, views, {}, job);
    if (lights.placement) {
        note_coverage(*lights.placement, record);
        record.setup.placed_rig = rig_text(lights.rig);
    }
    return std::move(lights.rig);
}

void measure_lines(const Scene& scene, const LightRig& rig, const NamedView& view,
                   FixtureRecord& record, const Job& job) {
    const std::vector<LineSource> sources = line_sources(rig);
    if (sources.empty()) return;
    const auto lines = surface_lines(scene.model, scene.seen(), sources, view.camera, {}, job);
    append(record.metrics, line_metrics(view.name, sources, lines));
}

} // namespace

FixtureRecord run_fixture(const FixtureSpec& spec, const FixtureSetup& kept,
                          const LoadOptions& load, const Job& job) {
    FixtureRecord record;
    const Scene scene = open_fixture(spec, load, job);
    measure_geometry(scene, spec, record, job);
    if (!spec.checks.lines && !spec.checks.pictures) return record;
    const std::vector<NamedView> views = views_of(scene, spec, kept, record.setup, job);
    const LightRig rig = rig_of(scene, spec, views, kept, record, job);
    PictureOptions options;
    for (const std::string& layer : spec.layers) options.aovs.push_back(aov_by_name(layer));
    for (const NamedView& view : views) {
        if (spec.checks.lines) measure_lines(scene, rig, view, record, job);
        if (spec.checks.pictures)
            record.pictures.push_back(
                {view.name, render_view(scene, rig, view.camera, options, job)});
    }
    return record;
}

std::string fixture_key(const fs::path& file, const FixtureSetup& kept, const LoadOptions& load) {
    std::string settings;
    if (kept != FixtureSetup())
        for (const auto& [name, bytes] : files_of({{{}, {}, kept}, "", {}})) settings += bytes;
    return input_key({&file, 1}, file.lexically_normal().parent_path(), load, settings);
}

} // namespace keiko
