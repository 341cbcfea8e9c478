#pragma once

#include "keiko/math/rgb.h"
#include "keiko/render/lit_spot.h"
#include "keiko/trace/hit.h"
#include "keiko/trace/path_counts.h"

#include <optional>
#include <vector>

namespace keiko {

/// What one eye ray brings back.
struct EyeSample {
    Rgb luminance;          ///< cd/m2
    std::optional<Hit> hit; ///< the first surface
    double illuminance = 0; ///< lx of direct light on it, where an AOV asks for it
    /// Where the first mirrored ray meets the nearest C-plane, mm; nothing where the body is in the
    /// way.
    std::optional<Vec2> c_plane;
    /// The face that the first mirrored ray meets, or nothing where it leaves the body.
    std::optional<std::uint32_t> mirrored_face;
    /// The image of the pixel that the first mirrored ray stands for is not smooth.
    bool torn = false;
    std::uint32_t paint = 0; ///< faces of one paint share this number
    PathCounts paths;        ///< of its hits, the mirrored rays' too
};

/// What eye rays bring back without the light of lamps on bases and lobes, and where that falls.
struct EyeView {
    std::vector<EyeSample> samples; ///< one a ray, in order
    std::vector<LitSpot> spots;     ///< by depth, then by sample
};

/// The inner part of the view of a grid of rays, `width` in a row, one ray off on all sides.
EyeView without_border(const EyeView& view, int width);

} // namespace keiko
