#include "keiko/workflow/compare_bodies.h"

#include "keiko/base/job_steps.h"
#include "keiko/files/scene/rig_file.h"
#include "keiko/geometry/trim/material_bounds.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/workflow/compare_views.h"
#include "keiko/workflow/hidden_faces.h"
#include "keiko/workflow/version.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace keiko {
namespace fs = std::filesystem;
namespace {

/// Opens the scene of a file, with pictures of the size of the views.
OpenBody opener_of(const fs::path& file, const CompareBodiesOptions& options) {
    return [&](const Job& job) {
        const std::array inputs{file};
        Scene scene = open_scene(inputs, options.scene, job);
        if (options.views && options.views->width > 0)
            scene.set_picture_size(options.views->width, options.views->height);
        return scene;
    };
}

std::vector<std::string> names_of(const SurfaceModel& model, const PlacedModel& placed) {
    std::vector<std::string> names;
    for (const PlacedFace& face : placed.origin)
        names.push_back(placed_face_name(model, face.instance, face.face));
    return names;
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

/// Both bodies, or the parts of them that are compared.
struct BodyPair {
    const ClosestPointQuery &before, &after;
};

DeviationOptions deviation_options(const ClosestPointQuery& before,
                                   const CompareBodiesOptions& options, const Job& job) {
    DeviationOptions deviation = options.deviation;
    constexpr double fiftieth = 0.02;
    deviation.reach = options.reach > 0
                          ? options.reach
                          : fiftieth * material_bounds(before.body().model, job).size();
    return deviation;
}

/// Numbers the partners of faces as the part of the other body has them; none out of the scope.
void number_partners(Deviation& deviation, const PlacedModel& whole, const PlacedModel& part) {
    for (FaceDeviation& face : deviation.faces) {
        if (face.partner == no_index) continue;
        const auto found =
            std::find(part.origin.begin(), part.origin.end(), whole.origin[face.partner]);
        face.partner = found == part.origin.end()
                           ? no_index
                           : static_cast<std::uint32_t>(found - part.origin.begin());
    }
}

/// Compares the parts in the scope, each with the whole of the other body.
void compare_geometry(const BodyPair& whole, const BodyPair& parts,
                      const CompareBodiesOptions& options, Comparison& comparison, const Job& job) {
    constexpr int stages = 2;
    JobSteps steps(job, 2);
    const DeviationOptions deviation = deviation_options(whole.before, options, job);
    comparison.deviation =
        measure_deviation(parts.after, whole.before, deviation, steps.next(1, stages));
    comparison.missing =
        measure_deviation(parts.before, whole.after, deviation, steps.next(1, stages));
    if (&parts.before == &whole.before) return;
    number_partners(comparison.deviation, whole.before.body(), parts.before.body());
    number_partners(comparison.missing, whole.after.body(), parts.after.body());
}

/// The faces of a body in the scope.
PlacedModel part_in_scope(const PlacedModel& body, const FaceLimits& limits) {
    PlacedModel part = body;
    part.model.faces.clear(), part.model.patches.clear(), part.origin.clear();
    for (std::size_t i = 0; i < body.origin.size(); ++i) {
        if (!limits.in_scope(body.origin[i])) continue;
        Face face = body.model.faces[i];
        const std::span<const Patch> patches = body.model.patches_of(face);
        face.first_patch = static_cast<std::uint32_t>(part.model.patches.size());
        for (Patch patch : patches) {
            patch.face = static_cast<std::uint32_t>(part.model.faces.size());
            part.model.patches.push_back(patch);
        }
        part.model.faces.push_back(std::move(face)), part.origin.push_back(body.origin[i]);
    }
    part.model.parts.front().face_count = static_cast<std::uint32_t>(part.model.faces.size());
    return part;
}

/// The part of a body in the scope, unless that is all of it.
std::optional<ClosestPointQuery> query_in_scope(const ClosestPointQuery& body,
                                                const FaceLimits& limits, const Job& job) {
    if (limits.scope().empty()) return std::nullopt;
    return std::optional<ClosestPointQuery>(std::in_place, part_in_scope(body.body(), limits), job);
}

void compare_seams(const Scene& before, const Scene& after, const LimitPair& limits,
                   const CompareBodiesOptions& options, Comparison& comparison, const Job& job) {
    JobSteps steps(job, 2);
    comparison.inspection_before =
        inspect(before.model, limits.before, options.join, steps.next(1, inspection_stages));
    comparison.inspection_after =
        inspect(after.model, limits.after, options.join, steps.next(1, inspection_stages));
    comparison.seams = compare_inspections(comparison.inspection_before,
                                           comparison.inspection_after, options.seams);
}

/// Remarks on the parts of the analysis that could not be followed on either body.
Diagnostics remarks_of(const Scene& before, const Scene& after) {
    Diagnostics remarks;
    for (const Scene* scene : {&before, &after}) {
        if (!scene->analysis) continue;
        for (Diagnostic remark : scene->analysis->remarks) {
            remark.entity.insert(0, source_of(*scene) + ": ");
            remarks.push_back(std::move(remark));
        }
    }
    return remarks;
}

/// Weights of the steps of a comparison.
constexpr double mirroring = 1, aligning = 2, limiting = 1, measuring = 4, inspecting = 16,
                 viewing = 30;

double weight_of_comparing(const CompareBodiesOptions& options) {
    return (options.mirror ? mirroring : 0) + aligning + limiting + measuring + inspecting +
           (options.views ? viewing : 0);
}

CompareResult compare_scenes(const Scene& before, Scene after, const CompareBodiesOptions& options,
                             const Job& job) {
    CompareResult result;
    Comparison& comparison = result.comparison;
    comparison.tool_version = version();
    comparison.before = source_of(before), comparison.after = source_of(after);
    if (options.mirror) comparison.after += ", mirrored at " + options.mirror->text();
    comparison.tolerance = options.tolerance;
    JobSteps steps(job, weight_of_comparing(options));
    if (options.mirror)
        after = moved_scene(std::move(after), options.mirror->motion(), options.scene,
                            steps.next(mirroring));
    result.remarks = remarks_of(before, after);
    const Job to_align = steps.next(aligning, 3);
    const ClosestPointQuery feet_before(placed_model(before.model), to_align);
    const ClosestPointQuery feet_after = aligned(after, feet_before, options, comparison, to_align);
    const Job to_limit = steps.next(limiting, 2);
    const LimitPair limits{limits_in(before, options.preset, options.scope, to_limit),
                           limits_in(after, options.preset, options.scope, to_limit)};
    const auto part_before = query_in_scope(feet_before, limits.before, to_limit);
    const auto part_after = query_in_scope(feet_after, limits.after, to_limit);
    const BodyPair whole{feet_before, feet_after};
    const BodyPair parts{part_before ? *part_before : feet_before,
                         part_after ? *part_after : feet_after};
    comparison.faces_before = names_of(before.model, parts.before.body());
    comparison.faces_after = names_of(after.model, parts.after.body());
    compare_geometry(whole, parts, options, comparison, steps.next_of_steps(measuring));
    compare_seams(before, after, limits, options, comparison, steps.next_of_steps(inspecting));
    if (!options.views) return result;
    Comparison of_all; // pictures show whole bodies
    if (part_before)
        compare_geometry(whole, whole, options, of_all, steps.next_of_steps(measuring));
    const Comparison& shown = part_before ? of_all : comparison;
    SharedFaces faces(feet_before.body(), shown.missing, feet_after.body(), shown.deviation);
    const auto shown_before = without_hidden_faces(before, job),
               shown_after = without_hidden_faces(after, job);
    compare_views({shown_before ? *shown_before : before, shown_after ? *shown_after : after,
                   feet_before, feet_after, faces, shown.deviation, limits},
                  options, result, steps.next_of_steps(viewing));
    return result;
}

} // namespace

CompareResult compare_bodies(const fs::path& before, const fs::path& after,
                             const CompareBodiesOptions& options, const Job& job) {
    return compare_bodies(opener_of(before, options), opener_of(after, options), options, job);
}

CompareResult compare_bodies(const OpenBody& before, const OpenBody& after,
                             const CompareBodiesOptions& options, const Job& job) {
    constexpr double opening = 2;
    JobSteps steps(job, 2 * opening + weight_of_comparing(options));
    const Scene former = before(steps.next_of_steps(opening));
    Scene latter = after(steps.next_of_steps(opening));
    return compare_scenes(former, std::move(latter), options,
                          steps.next_of_steps(weight_of_comparing(options)));
}

FolderContent comparison_files(const fs::path& folder, const CompareResult& result) {
    FolderContent files = result.comparison.pngs;
    if (result.rig) files["rig.toml"] = rig_text(*result.rig, folder);
    files["compare.json"] = comparison_json(result.comparison);
    files["compare.html"] = comparison_html(result.comparison);
    return files;
}

} // namespace keiko
