#pragma once

#include "keiko/base/export.h"
#include "keiko/film/film.h"
#include "keiko/light/rig/light_rig.h"
#include "keiko/scene/camera.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace KEIKO_API keiko {

/// Modes of pictures of a surface other than under its lamps.
enum class AnalysisMode {
    zebra,     ///< a sky of black and white rings about the vertical, reflected
    isophote,  ///< bands of equal angle between the normal and the vertical
    highlight, ///< bands between the lamps of a rig by where the normal meets their C-plane
    gauss,     ///< Gaussian curvature by colour
    mean,      ///< mean curvature by colour
    k1,        ///< the larger principal curvature by colour
    k2         ///< the smaller one
};

/// "zebra", "isophote", "highlight", "curvature:gauss", "curvature:mean", "curvature:k1",
/// "curvature:k2"
std::string_view name_of(AnalysisMode look);
/// All modes, in the order of their declaration.
const std::vector<AnalysisMode>& every_look();
/// True for the modes that show a curvature by colour.
bool is_curvature(AnalysisMode look);

/// The layers of a film that analysis pictures need.
std::vector<Aov> look_layers();

/// The display picture of a film's surface, with a legend if colours represent numbers. Curvatures
/// are positive in hollows as viewed from the camera; their colours are saturated at +-`full`, or
/// else at usual_curvature. Stripes are averaged over pixels. Highlight bands are as wide as the
/// gaps between them; a surface whose normal meets no C-plane of the rig is grey.
Image analysis_picture(AnalysisMode look, const Film& film, const Camera& camera,
                       const LightRig& rig, std::optional<double> full = {});

/// The round curvature, 1/mm or 1/mm2, that 2 % of the body's picture exceed.
double usual_curvature(AnalysisMode look, const Film& film, const Camera& camera);

} // namespace keiko
