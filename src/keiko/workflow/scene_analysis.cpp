#include "keiko/workflow/scene_analysis.h"

#include "keiko/workflow/analysis_picture.h"
#include "keiko/workflow/glass_deviation.h"
#include "keiko/workflow/section_curvature.h"

namespace keiko {

Image scene_analysis(const Scene& scene, const Camera& camera, const LightRig& rig,
                     const ChosenMode& chosen, const Job& job) {
    // The surface is shown by itself: no light is computed.
    const PictureOptions layers{
        .aovs = look_layers(chosen.look), .max_depth = 0, .max_crossings = 0};
    const Film film = render_view(scene, {}, camera, layers, job);
    AnalysisOptions options = chosen.options;
    if (chosen.look == AnalysisMode::section)
        options.sections = section_curvatures(scene.seen(), camera, chosen.section, job);
    if (chosen.look == AnalysisMode::distortion)
        options.deviations = glass_deviations(scene.seen(), scene.seen_materials(), camera, job);
    options.ground = 0;
    return analysis_picture(chosen.look, film, camera, rig, options);
}

} // namespace keiko
