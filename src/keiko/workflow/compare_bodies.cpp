#include "keiko/workflow/compare_bodies.h"

#include "keiko/base/job_steps.h"
#include "keiko/compare/shape/deviation_map.h"
#include "keiko/files/scene/rig_file.h"
#include "keiko/film/image_difference.h"
#include "keiko/film/image_file.h"
#include "keiko/film/signed_color_picture.h"
#include "keiko/geometry/trim/material_bounds.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/workflow/draw_outcome.h"
#include "keiko/workflow/find_lines.h"
#include "keiko/workflow/hidden_faces.h"
#include "keiko/workflow/place_scene.h"
#include "keiko/workflow/version.h"
#include "keiko/workflow/zoned_limits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

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

/// Limits of the faces of both bodies.
struct LimitPair {
    FaceLimits before, after;
};

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

/// Both bodies ready to be rendered, and their deviation.
struct ComparedScenes {
    const Scene& before;
    const Scene& after;
    const ClosestPointQuery &feet_before, &feet_after;
    SharedFaces& faces;
    const Deviation& deviation; ///< of the latter from the former
    const LimitPair& limits;
};

/// Source of the lamps of the views, for the report.
std::string source_of(const ChosenLights& lights, const CompareViewsOptions& options) {
    if (options.rig) return options.rig->string();
    return lights.placement ? "placed on the part before" : "those of the scene before";
}

/// The lines of a rig's lamps on one body, a view each.
std::vector<JoinedLines> lines_of(const Scene& scene, const LightRig& rig,
                                  std::span<const NamedView> views, const FaceLimits& limits,
                                  const CompareBodiesOptions& options, const Job& job) {
    std::vector<JoinedLines> lines(views.size());
    if (!has_lines(rig)) return lines;
    LinesOptions asked;
    asked.preset = options.preset;
    asked.join = options.join;
    LineList list = lines_under(scene, rig, views, asked, limits, job);
    for (std::size_t i = 0; i < views.size(); ++i) lines[i] = std::move(list.views[i].found);
    return lines;
}

/// The parts of lines that lie on faces in the scope.
JoinedLines lines_in_scope(JoinedLines lines, const FaceLimits& limits) {
    for (JoinedLine& line : lines.lines)
        std::erase_if(line.pieces, [&](std::uint32_t piece) {
            const SurfaceLine& on = lines.pieces[piece];
            return !limits.in_scope(PlacedFace{on.instance, on.face});
        });
    std::erase_if(lines.lines, [](const JoinedLine& line) { return line.pieces.empty(); });
    return lines;
}

/// Numbers of the faces with an instance in the scope, as pictures have them.
std::set<float> ids_in_scope(const SurfaceModel& model, const FaceLimits& limits) {
    std::set<float> ids;
    for (const PlacedFace& face : placed_faces(model))
        if (limits.in_scope(face)) ids.insert(static_cast<float>(model.faces[face.face].id));
    return ids;
}

/// 1 in the pixels of two pictures that show no face in the scope, 1 channel; nothing if all faces
/// are. Pictures show faces by Face::id.
std::optional<Image> pixels_out_of_scope(const SurfaceModel& before, const Film& film_before,
                                         const SurfaceModel& after, const Film& film_after,
                                         const LimitPair& limits) {
    if (limits.before.scope().empty()) return std::nullopt;
    const std::set<float> ids_before = ids_in_scope(before, limits.before),
                          ids_after = ids_in_scope(after, limits.after);
    const Image &a = film_before.aovs.at(Aov::face), &b = film_after.aovs.at(Aov::face);
    Image out(a.width, a.height, 1);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x)
            if (!ids_before.contains(*a.pixel(x, y)) && !ids_after.contains(*b.pixel(x, y)))
                *out.pixel(x, y) = 1;
    return out;
}

/// Deviation at which a map is saturated, mm: nearly all of the area lies within.
double map_scale(const Deviation& deviation, double tolerance) {
    const double farthest = std::max(std::abs(deviation.lowest), std::abs(deviation.highest));
    const double most = std::isfinite(deviation.percent_99_9) ? deviation.percent_99_9 : farthest;
    return round_scale(std::max({most, tolerance, 1e-9}));
}

/// A body in its pictures, with the names that `name` gives its faces by their numbers.
template <class Name>
OutlineBody outline_body(const Scene& scene, const ClosestPointQuery& feet, const Name& name) {
    OutlineBody body{.tracer = scene.seen(),
                     .feet = feet,
                     .paints = scene.seen_materials(),
                     .visible_names = {},
                     .placed_names = {}};
    for (const Face& face : scene.model.faces) body.visible_names.push_back(name(face.id));
    for (const Face& face : feet.body().model.faces) body.placed_names.push_back(name(face.id));
    if (!scene.surroundings) return body;
    body.visible_names.push_back(name(0));
    body.ground = scene.surroundings->ground;
    return body;
}

class ViewComparer {
public:
    static constexpr int stages = 6; ///< of a view

    ViewComparer(const ComparedScenes& scenes, const LightRig& rig,
                 const CompareBodiesOptions& options)
        : scenes_(scenes),
          rig_(rig),
          options_(options),
          before_(outline_body(scenes.before, scenes.feet_before,
                               [&](std::uint32_t id) { return scenes.faces.name_before(id); })),
          after_(outline_body(scenes.after, scenes.feet_after,
                              [&](std::uint32_t id) { return scenes.faces.name_after(id); })) {
        picture_.aovs = {Aov::normal, Aov::face, Aov::depth};
    }

    ComparedView compare(const NamedView& view, const JoinedLines& before, const JoinedLines& after,
                         FolderContent& pngs, const Job& job) {
        ComparedView compared;
        compared.picture.view = view.name;
        compare_pictures(view.camera, compared, pngs, job);
        draw_map(view.camera, compared, pngs, job);
        const LimitPair& limits = scenes_.limits;
        const LineShiftOptions& shift = options_.views->shift;
        compared.lines = line_shifts(lines_in_scope(before, limits.before), after, shift, job);
        compared.after_lines = line_shifts(lines_in_scope(after, limits.after), before, shift, job);
        return compared;
    }

private:
    void compare_pictures(const Camera& camera, ComparedView& view, FolderContent& pngs,
                          const Job& job) {
        Film before = render_view(scenes_.before, rig_, camera, picture_, job);
        Film after = render_view(scenes_.after, rig_, camera, picture_, job);
        const std::optional<Image> out = pixels_out_of_scope(
            scenes_.before.model, before, scenes_.after.model, after, scenes_.limits);
        const Image* left_out = out ? &*out : nullptr;
        scenes_.faces.rename_before(before), scenes_.faces.rename_after(after);
        const OutlineComparison outlines(before_, after_, camera, outline_tolerance(),
                                         scenes_.deviation.reach);
        FilmTolerance tolerance = options_.views->tolerance;
        view.outlines =
            outline_difference(outlines, before, after,
                               film_difference(before, after, tolerance, left_out), camera, job);
        if (left_out) view.outlines.left_out = larger_of(view.outlines.left_out, *left_out);
        tolerance.flips = 0; // the remaining ones are measured to be too large
        const FilmDifference difference =
            film_difference(before, after, tolerance, &view.outlines.left_out);
        view.picture.take(difference);
        draw_outcome(view.picture, &before, &after, &difference.excess, pngs);
    }

    OutlineTolerance outline_tolerance() const {
        const BodyTolerance& tolerance = options_.tolerance;
        return {tolerance.outline, tolerance.outline_pixels, tolerance.deviation, tolerance.normal};
    }

    void draw_map(const Camera& camera, ComparedView& view, FolderContent& pngs, const Job& job) {
        const DeviationMap map = deviation_map(scenes_.after.tracer, camera, scenes_.feet_before,
                                               scenes_.deviation.reach, job);
        const double most = map_scale(scenes_.deviation, options_.tolerance.deviation);
        const Image picture = signed_color_picture(map.distance, map.facing, {-most, most}, "mm");
        view.map = view.picture.view + "-deviation.png";
        view.map_width = picture.width, view.map_height = picture.height;
        pngs[view.map] = encode_png(picture);
    }

    const ComparedScenes& scenes_;
    const LightRig& rig_;
    const CompareBodiesOptions& options_;
    OutlineBody before_, after_;
    PictureOptions picture_;
};

/// Renders both under the same cameras and lamps, compares pictures and reflection lines, and draws
/// the distance maps. Adds rig, views and pictures to the result. Throws Error, Cancelled.
void compare_views(const ComparedScenes& scenes, const CompareBodiesOptions& options,
                   CompareResult& result, const Job& job) {
    constexpr int automatic_views = 3;
    constexpr double choosing = 1.5, placing = 3, following = 3, comparing = 5;
    const auto count = static_cast<double>(
        options.views->views.empty() ? automatic_views : options.views->views.size());
    JobSteps steps(job, choosing + placing + (2 * following + comparing) * count);
    const std::vector<NamedView> views =
        choose_views(scenes.before, options.views->views, automatic_views, steps.next(choosing));
    ChosenLights lights =
        choose_lights(scenes.before, options.views->rig, views, {}, steps.next(placing, 3));
    result.comparison.rig = source_of(lights, *options.views);
    result.rig = std::move(lights.rig);
    ViewComparer comparer(scenes, *result.rig, options);
    const auto before = lines_of(scenes.before, *result.rig, views, scenes.limits.before, options,
                                 steps.next_of_steps(following * count));
    const auto after = lines_of(scenes.after, *result.rig, views, scenes.limits.after, options,
                                steps.next_of_steps(following * count));
    for (std::size_t i = 0; i < views.size(); ++i)
        result.comparison.views.push_back(
            comparer.compare(views[i], before[i], after[i], result.comparison.pngs,
                             steps.next(comparing, ViewComparer::stages, views[i].name)));
}

/// Remarks on the parts of the analysis that could not be followed on either body.
Diagnostics remarks_of(const Scene& before, const Scene& after) {
    Diagnostics remarks;
    for (const auto& [scene, file] :
         {std::pair(&before, before.inputs.front()), std::pair(&after, after.inputs.front())}) {
        if (!scene->analysis) continue;
        for (Diagnostic remark : scene->analysis->remarks) {
            remark.entity.insert(0, file.string() + ": ");
            remarks.push_back(std::move(remark));
        }
    }
    return remarks;
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
    constexpr double opening = 2, aligning = 2, limiting = 1, measuring = 4, inspecting = 16,
                     viewing = 30;
    JobSteps steps(job, 2 * opening + aligning + limiting + measuring + inspecting +
                            (options.views ? viewing : 0));
    const Scene scene_before = opened(before, options, steps.next_of_steps(opening));
    Scene scene_after = opened_after(after, options, steps.next_of_steps(opening));
    result.remarks = remarks_of(scene_before, scene_after);
    const Job to_align = steps.next(aligning, 3);
    const ClosestPointQuery feet_before(placed_model(scene_before.model), to_align);
    const ClosestPointQuery feet_after =
        aligned(scene_after, feet_before, options, comparison, to_align);
    const Job to_limit = steps.next(limiting, 2);
    const LimitPair limits{limits_in(scene_before, options.preset, options.scope, to_limit),
                           limits_in(scene_after, options.preset, options.scope, to_limit)};
    const auto part_before = query_in_scope(feet_before, limits.before, to_limit);
    const auto part_after = query_in_scope(feet_after, limits.after, to_limit);
    const BodyPair whole{feet_before, feet_after};
    const BodyPair parts{part_before ? *part_before : feet_before,
                         part_after ? *part_after : feet_after};
    comparison.faces_before = names_of(scene_before.model, parts.before.body());
    comparison.faces_after = names_of(scene_after.model, parts.after.body());
    compare_geometry(whole, parts, options, comparison, steps.next_of_steps(measuring));
    compare_seams(scene_before, scene_after, limits, options, comparison,
                  steps.next_of_steps(inspecting));
    if (!options.views) return result;
    Comparison of_all; // pictures show whole bodies
    if (part_before)
        compare_geometry(whole, whole, options, of_all, steps.next_of_steps(measuring));
    const Comparison& shown = part_before ? of_all : comparison;
    SharedFaces faces(feet_before.body(), shown.missing, feet_after.body(), shown.deviation);
    const auto shown_before = without_hidden_faces(scene_before, job),
               shown_after = without_hidden_faces(scene_after, job);
    compare_views(
        {shown_before ? *shown_before : scene_before, shown_after ? *shown_after : scene_after,
         feet_before, feet_after, faces, shown.deviation, limits},
        options, result, steps.next_of_steps(viewing));
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
