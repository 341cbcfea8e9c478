#include "keiko/run_fixture.h"

#include "keiko/choose_lights.h"
#include "keiko/compare/body_metrics.h"
#include "keiko/input_key.h"

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

std::vector<NamedView> views_of(const Scene& scene, const FixtureSpec& spec, const Job& job) {
    if (spec.views.empty() && !scene.camera && !scene.view)
        throw Error(spec.file.string(), "views", "are missing: the body has no camera of its own");
    return choose_views(scene, spec.views, 1, job);
}

void append(std::vector<Metric>& to, std::vector<Metric> more) {
    to.insert(to.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

void measure_geometry(const Scene& scene, const FixtureSpec& spec, FixtureRecord& record,
                      const Job& job) {
    if (!spec.checks.shape && !spec.checks.seams) return;
    const Inspection inspection = inspect(scene.model, spec.preset, spec.join, job);
    if (spec.checks.shape) append(record.metrics, shape_metrics(scene.model, inspection.facts));
    if (spec.checks.seams) append(record.metrics, seam_metrics(inspection));
}

LightRig rig_of(const Scene& scene, const FixtureSpec& spec, std::span<const NamedView> views,
                FixtureRecord& record, const Job& job) {
    ChosenLights lights = choose_lights(scene, spec.rig, views, {}, job);
    if (lights.placement)
        record.metrics.push_back(
            {"lines", "coverage of the lamps placed", Quantity::share, lights.placement->coverage});
    return std::move(lights.rig);
}

void measure_lines(const Scene& scene, const LightRig& rig, const NamedView& view,
                   FixtureRecord& record, const Job& job) {
    std::vector<CPlane> planes;
    for (const LightSource& source : rig.sources)
        if (const auto* plane = std::get_if<CPlane>(&source)) planes.push_back(*plane);
    if (planes.empty()) return;
    const auto lines = surface_lines(scene.model, scene.seen(), planes, view.camera, {}, job);
    append(record.metrics, line_metrics(view.name, planes, lines));
}

} // namespace

FixtureRecord run_fixture(const FixtureSpec& spec, const LoadOptions& load, const Job& job) {
    FixtureRecord record;
    const Scene scene = open_fixture(spec, load, job);
    measure_geometry(scene, spec, record, job);
    if (!spec.checks.lines && !spec.checks.pictures) return record;
    const std::vector<NamedView> views = views_of(scene, spec, job);
    const LightRig rig = rig_of(scene, spec, views, record, job);
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

std::string fixture_key(const FixtureSpec& spec, const LoadOptions& load) {
    return input_key({&spec.file, 1}, spec.file.lexically_normal().parent_path(), load);
}

} // namespace keiko
