#pragma once

#include "keiko/inspect/lines/line_endpoint.h"

#include <string_view>

namespace keiko {

/// Reason why a line ends.
enum class LineEnd {
    closed,      ///< no end: it runs back into itself
    lamp,        ///< end of the lamp
    silhouette,  ///< the surface turns away from the viewpoint
    hidden,      ///< hidden by something, or its lamp's light is
    free_border, ///< end of the material
    crease,      ///< at a seam with more than the feature angle
    seam,        ///< at a seam beyond which it does not continue
    patch        ///< at a line inside a face, where the search lost it
};
std::string_view name_of(LineEnd end);

/// Reason why a line ends at the head or tail of a piece; `end`: what it meets there. Angles of
/// more than `feature_angle` degrees are creases.
LineEnd line_end(const SurfaceModel& model, const SurfaceLine& piece, bool head,
                 const LineBorders::End& end, const LineField& field, double feature_angle);

} // namespace keiko
