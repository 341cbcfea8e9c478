#include "keiko/workflow/analysis_picture.h"

#include "keiko/workflow/band_picture.h"
#include "keiko/workflow/curvature_picture.h"
#include "keiko/workflow/distortion_picture.h"
#include "keiko/workflow/draft_picture.h"
#include "keiko/workflow/patch_picture.h"
#include "keiko/workflow/radius_picture.h"

namespace keiko {

std::vector<Aov> look_layers(AnalysisMode look) {
    if (look == AnalysisMode::isoparms || look == AnalysisMode::patches)
        return {Aov::normal, Aov::face, Aov::depth, Aov::patch, Aov::uv};
    return {Aov::normal, Aov::face, Aov::depth, Aov::curvature};
}

double usual_curvature(AnalysisMode look, const Film& film, const Camera& camera) {
    const AnalysisOptions options;
    return curvature_range(look, FilmSight(film, camera, options.ground), options).high;
}

Image analysis_picture(AnalysisMode look, const Film& film, const Camera& camera,
                       const LightRig& rig, const AnalysisOptions& options) {
    const FilmSight sight(film, camera, options.ground);
    if (is_curvature(look)) return curvature_picture(look, sight, options);
    if (look == AnalysisMode::radius) return radius_picture(sight, options.scale);
    if (look == AnalysisMode::below_radius) return below_radius_picture(sight, options.radius);
    if (look == AnalysisMode::distortion)
        return distortion_picture(sight, *options.deviations, options.scale);
    if (look == AnalysisMode::draft) return draft_picture(sight, options);
    if (look == AnalysisMode::isoparms) return isoparm_picture(sight);
    if (look == AnalysisMode::patches) return patch_picture(sight);
    return band_picture(look, sight, camera, rig);
}

} // namespace keiko
