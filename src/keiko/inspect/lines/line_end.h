#pragma once

#include "keiko/inspect/lines/line_endpoint.h"

#include <string_view>

namespace keiko {

/// Why a line ends.
enum class LineEnd {
    closed,      ///< it does not: it runs back into itself
    lamp,        ///< with the lamp
    silhouette,  ///< where the surface turns away from the eye
    hidden,      ///< behind something, or its lamp's light does not get there
    free_border, ///< where the material ends
    crease,      ///< at a seam with more than the feature angle
    seam,        ///< at a seam beyond which it does not go on
    patch        ///< at a line inside a face, where the search lost it
};
std::string_view name_of(LineEnd end);

/// Why a line ends where a piece of it has its head or tail; `end`: what it meets there. Angles of
/// more than `feature_angle` degrees are creases.
LineEnd line_end(const SurfaceModel& model, const SurfaceLine& piece, bool head,
                 const LineBorders::End& end, const LineField& field, double feature_angle);

} // namespace keiko
