#include "keiko/compare_views.h"

#include "keiko/compare/deviation_map.h"
#include "keiko/draw_outcome.h"
#include "keiko/film/signed_color_picture.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

struct Lights {
    LightRig rig;
    std::string source; ///< what to tell of it
};

Lights lights_of(const Scene& scene, const CompareViewsOptions& options,
                 std::span<const NamedView> views, const Job& job) {
    if (options.rig) return {read_rig(*options.rig), options.rig->string()};
    if (scene.rig) return {*scene.rig, "those of the scene before"};
    std::vector<Camera> cameras;
    for (const NamedView& view : views) cameras.push_back(view.camera);
    return {place_lamps(scene.tracer, scene.model, cameras, {}, job).rig,
            "placed on the part before"};
}

/// The lines of a rig's lamps on one body, view after view.
class BodyLines {
public:
    BodyLines(const Scene& scene, const LightRig& rig, const CompareBodiesOptions& options,
              const Job& job)
        : scene_(scene), options_(options), job_(job) {
        for (const LightSource& source : rig.sources)
            if (const auto* plane = std::get_if<CPlane>(&source)) planes_.push_back(*plane);
        if (!planes_.empty()) seams_.emplace(scene.model, options.join, job);
    }
    JoinedLines in(const Camera& camera) const {
        if (planes_.empty()) return {};
        return join_lines(scene_.model, *seams_,
                          surface_lines(scene_.model, scene_.seen(), planes_, camera, {}, job_),
                          planes_, camera, LineLook::reflection, options_.preset, job_);
    }

private:
    const Scene& scene_;
    const CompareBodiesOptions& options_;
    const Job& job_;
    std::vector<CPlane> planes_;
    std::optional<LineSeams> seams_;
};

/// What a map is full at, mm: nearly all of the area lies within.
double map_scale(const Deviation& deviation, double tolerance) {
    const double farthest = std::max(std::abs(deviation.lowest), std::abs(deviation.highest));
    const double most = std::isfinite(deviation.percent_99_9) ? deviation.percent_99_9 : farthest;
    return round_scale(std::max({most, tolerance, 1e-9}));
}

class ViewComparer {
public:
    ViewComparer(const ComparedScenes& scenes, const LightRig& rig,
                 const CompareBodiesOptions& options, const Job& job)
        : scenes_(scenes),
          rig_(rig),
          options_(options),
          job_(job),
          lines_before_(scenes.before, rig, options, job),
          lines_after_(scenes.after, rig, options, job) {
        picture_.aovs = {Aov::normal, Aov::face, Aov::depth};
    }

    ComparedView compare(const NamedView& view, FolderContent& pngs) {
        ComparedView compared;
        compared.picture.view = view.name;
        compare_pictures(view.camera, compared.picture, pngs);
        draw_map(view.camera, compared, pngs);
        const JoinedLines before = lines_before_.in(view.camera),
                          after = lines_after_.in(view.camera);
        compared.lines = line_shifts(before, after, options_.views->shift, job_);
        compared.after_lines = line_shifts(after, before, options_.views->shift, job_);
        return compared;
    }

private:
    void compare_pictures(const Camera& camera, PictureOutcome& picture, FolderContent& pngs) {
        Film before = render_view(scenes_.before, rig_, camera, picture_, job_);
        Film after = render_view(scenes_.after, rig_, camera, picture_, job_);
        scenes_.faces.rename_before(before), scenes_.faces.rename_after(after);
        const FilmDifference difference = film_difference(before, after, options_.views->tolerance);
        picture.take(difference);
        draw_outcome(picture, &before, &after, &difference.excess, pngs);
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
    BodyLines lines_before_, lines_after_;
    PictureOptions picture_;
};

} // namespace

void compare_views(const ComparedScenes& scenes, const CompareBodiesOptions& options,
                   CompareResult& result, const Job& job) {
    constexpr int automatic_views = 3;
    const std::vector<NamedView> views =
        choose_views(scenes.before, options.views->views, automatic_views, job);
    auto [rig, source] = lights_of(scenes.before, *options.views, views, job);
    result.rig = std::move(rig);
    result.comparison.rig = std::move(source);
    ViewComparer comparer(scenes, *result.rig, options, job);
    for (const NamedView& view : views)
        result.comparison.views.push_back(comparer.compare(view, result.comparison.pngs));
}

} // namespace keiko
