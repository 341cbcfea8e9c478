#include "keiko/workflow/compare_views.h"

#include "keiko/compare/shape/deviation_map.h"
#include "keiko/film/image_file.h"
#include "keiko/film/signed_color_picture.h"
#include "keiko/workflow/choose_lights.h"
#include "keiko/workflow/draw_outcome.h"
#include "keiko/workflow/find_lines.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Source of the lamps of the views, for the report.
std::string source_of(const ChosenLights& lights, const CompareViewsOptions& options) {
    if (options.rig) return options.rig->string();
    return lights.placement ? "placed on the part before" : "those of the scene before";
}

/// The lines of a rig's lamps on one body, a view each.
std::vector<JoinedLines> lines_of(const Scene& scene, const LightRig& rig,
                                  std::span<const NamedView> views,
                                  const CompareBodiesOptions& options, const Job& job) {
    std::vector<JoinedLines> lines(views.size());
    if (!has_lines(rig)) return lines;
    LinesOptions asked;
    asked.preset = options.preset;
    asked.join = options.join;
    LineList list = lines_under(scene, rig, views, asked, job);
    for (std::size_t i = 0; i < views.size(); ++i) lines[i] = std::move(list.views[i].found);
    return lines;
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
    ViewComparer(const ComparedScenes& scenes, const LightRig& rig,
                 const CompareBodiesOptions& options, const Job& job)
        : scenes_(scenes),
          rig_(rig),
          options_(options),
          job_(job),
          before_(outline_body(scenes.before, scenes.feet_before,
                               [&](std::uint32_t id) { return scenes.faces.name_before(id); })),
          after_(outline_body(scenes.after, scenes.feet_after,
                              [&](std::uint32_t id) { return scenes.faces.name_after(id); })) {
        picture_.aovs = {Aov::normal, Aov::face, Aov::depth};
    }

    ComparedView compare(const NamedView& view, const JoinedLines& before, const JoinedLines& after,
                         FolderContent& pngs) {
        ComparedView compared;
        compared.picture.view = view.name;
        compare_pictures(view.camera, compared, pngs);
        draw_map(view.camera, compared, pngs);
        compared.lines = line_shifts(before, after, options_.views->shift, job_);
        compared.after_lines = line_shifts(after, before, options_.views->shift, job_);
        return compared;
    }

private:
    void compare_pictures(const Camera& camera, ComparedView& view, FolderContent& pngs) {
        Film before = render_view(scenes_.before, rig_, camera, picture_, job_);
        Film after = render_view(scenes_.after, rig_, camera, picture_, job_);
        scenes_.faces.rename_before(before), scenes_.faces.rename_after(after);
        const OutlineComparison outlines(before_, after_, camera, outline_tolerance(),
                                         scenes_.deviation.reach);
        FilmTolerance tolerance = options_.views->tolerance;
        view.outlines = outline_difference(outlines, before, after,
                                           film_difference(before, after, tolerance), camera, job_);
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

    void draw_map(const Camera& camera, ComparedView& view, FolderContent& pngs) {
        const DeviationMap map = deviation_map(scenes_.after.tracer, camera, scenes_.feet_before,
                                               scenes_.deviation.reach, job_);
        const Image picture =
            signed_color_picture(map.distance, map.facing,
                                 map_scale(scenes_.deviation, options_.tolerance.deviation), "mm");
        view.map = view.picture.view + "-deviation.png";
        view.map_width = picture.width, view.map_height = picture.height;
        pngs[view.map] = encode_png(picture);
    }

    const ComparedScenes& scenes_;
    const LightRig& rig_;
    const CompareBodiesOptions& options_;
    const Job& job_;
    OutlineBody before_, after_;
    PictureOptions picture_;
};

} // namespace

void compare_views(const ComparedScenes& scenes, const CompareBodiesOptions& options,
                   CompareResult& result, const Job& job) {
    constexpr int automatic_views = 3;
    const std::vector<NamedView> views =
        choose_views(scenes.before, options.views->views, automatic_views, job);
    ChosenLights lights = choose_lights(scenes.before, options.views->rig, views, {}, job);
    result.comparison.rig = source_of(lights, *options.views);
    result.rig = std::move(lights.rig);
    ViewComparer comparer(scenes, *result.rig, options, job);
    const auto before = lines_of(scenes.before, *result.rig, views, options, job);
    const auto after = lines_of(scenes.after, *result.rig, views, options, job);
    for (std::size_t i = 0; i < views.size(); ++i)
        result.comparison.views.push_back(
            comparer.compare(views[i], before[i], after[i], result.comparison.pngs));
}

} // namespace keiko
