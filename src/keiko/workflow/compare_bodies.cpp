#include "keiko/workflow/compare_bodies.h"

#include "keiko/files/scene/rig_file.h"
#include "keiko/geometry/trim/material_bounds.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/workflow/compare_views.h"
#include "keiko/workflow/version.h"

#include <array>

namespace keiko {
namespace fs = std::filesystem;
namespace {

Scene opened(const fs::path& file, const CompareBodiesOptions& options, const Job& job) {
    const std::array inputs{file};
    Scene scene = open_scene(inputs, options.scene, job);
    if (options.views && options.views->width > 0)
        scene.set_picture_size(options.views->width, options.views->height);
    return scene;
}

std::vector<std::string> names_of(const SurfaceModel& model, const PlacedModel& placed) {
    std::vector<std::string> names;
    for (const PlacedFace& face : placed.origin)
        names.push_back(placed_face_name(model, face.instance, face.face));
    return names;
}

/// The latter, mirrored if requested.
Scene opened_after(const fs::path& file, const CompareBodiesOptions& options, const Job& job) {
    Scene scene = opened(file, options, job);
    if (!options.mirror) return scene;
    return moved_scene(std::move(scene), options.mirror->motion(), options.scene, job);
}

/// Moves the latter onto the former, if requested.
ClosestPointQuery aligned(Scene& after, const ClosestPointQuery& before,
                          const CompareBodiesOptions& options, Comparison& comparison,
                          const Job& job) {
    ClosestPointQuery feet(placed_model(after.model), job);
    if (!options.align) return feet;
    comparison.alignment = align_bodies(feet, before, {}, job);
    after = moved_scene(std::move(after), comparison.alignment->motion, options.scene, job);
    return ClosestPointQuery(placed_model(after.model), job);
}

void compare_geometry(const ClosestPointQuery& before, const ClosestPointQuery& after,
                      const CompareBodiesOptions& options, Comparison& comparison, const Job& job) {
    DeviationOptions deviation = options.deviation;
    constexpr double fiftieth = 0.02;
    deviation.reach = options.reach > 0
                          ? options.reach
                          : fiftieth * material_bounds(before.body().model, job).size();
    comparison.deviation = measure_deviation(after, before, deviation, job);
    comparison.missing = measure_deviation(before, after, deviation, job);
}

void compare_seams(const Scene& before, const Scene& after, const CompareBodiesOptions& options,
                   Comparison& comparison, const Job& job) {
    comparison.inspection_before = inspect(before.model, options.preset, options.join, job);
    comparison.inspection_after = inspect(after.model, options.preset, options.join, job);
    comparison.seams = compare_inspections(comparison.inspection_before,
                                           comparison.inspection_after, options.seams);
}

} // namespace

CompareResult compare_bodies(const fs::path& before, const fs::path& after,
                             const CompareBodiesOptions& options, const Job& job) {
    CompareResult result;
    Comparison& comparison = result.comparison;
    comparison.tool_version = version();
    comparison.before = before.string(), comparison.after = after.string();
    if (options.mirror) comparison.after += ", mirrored at " + options.mirror->text();
    comparison.tolerance = options.tolerance;
    const Scene scene_before = opened(before, options, job);
    Scene scene_after = opened_after(after, options, job);
    const ClosestPointQuery feet_before(placed_model(scene_before.model), job);
    const ClosestPointQuery feet_after =
        aligned(scene_after, feet_before, options, comparison, job);
    comparison.faces_before = names_of(scene_before.model, feet_before.body());
    comparison.faces_after = names_of(scene_after.model, feet_after.body());
    compare_geometry(feet_before, feet_after, options, comparison, job);
    compare_seams(scene_before, scene_after, options, comparison, job);
    if (!options.views) return result;
    SharedFaces faces(feet_before.body(), comparison.missing, feet_after.body(),
                      comparison.deviation);
    compare_views({scene_before, scene_after, feet_before, feet_after, faces, comparison.deviation},
                  options, result, job);
    return result;
}

FolderContent comparison_files(const fs::path& folder, const CompareResult& result) {
    FolderContent files = result.comparison.pngs;
    if (result.rig) files["rig.toml"] = rig_text(*result.rig, folder);
    files["compare.json"] = comparison_json(result.comparison);
    files["compare.html"] = comparison_html(result.comparison);
    return files;
}

} // namespace keiko
