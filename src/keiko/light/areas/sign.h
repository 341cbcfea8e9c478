#pragma once

#include "keiko/base/export.h"
#include "keiko/light/areas/area_lights.h"

#include <vector>

namespace KEIKO_API keiko {

/// A luminous sign: a panel with a legend of shining polygons in its plane.
struct LuminousSign {
    PolygonLight panel;                 ///< whole, as if there were no legend
    std::vector<PolygonLight> legend{}; ///< within the panel, apart from each other

    /// Mean luminance of the legend over its area, cd/m2; that of the panel without one.
    double legend_luminance() const;
    /// Middle of the panel's corners, mm.
    Vec3 center() const;
    /// The panel without the places of its legend, then the parts of the legend.
    std::vector<PolygonLight> panels() const;

    bool operator==(const LuminousSign&) const = default;
};

/// A polygon without the holes in it, all in one plane and apart from each other. Its ring runs
/// along a cut to each hole and back, on which both ways cancel each other.
std::vector<Vec3> without_holes(std::vector<Vec3> outline, std::vector<std::vector<Vec3>> holes);

} // namespace keiko
