#include "keiko/workflow/compare_views.h"

#include "keiko/base/job_steps.h"
#include "keiko/compare/shape/deviation_map.h"
#include "keiko/film/image_difference.h"
#include "keiko/film/image_file.h"
#include "keiko/film/signed_color_picture.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/workflow/draw_outcome.h"
#include "keiko/workflow/find_lines.h"
#include "keiko/workflow/place_scene.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

namespace keiko {
namespace {

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

} // namespace

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

} // namespace keiko
