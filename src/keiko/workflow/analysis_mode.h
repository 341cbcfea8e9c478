#pragma once

#include "keiko/base/export.h"
#include "keiko/film/film.h"
#include "keiko/film/value_range.h"
#include "keiko/math/vec.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace KEIKO_API keiko {

/// Modes of pictures of a surface other than under its lamps.
enum class AnalysisMode {
    zebra,        ///< a sky of black and white rings about the vertical, reflected
    isophote,     ///< bands of equal angle between the normal and the vertical
    highlight,    ///< bands between the lamps of a rig by where the normal meets their C-plane
    draft,        ///< draft angle against a pull direction by colour
    gauss,        ///< Gaussian curvature by colour
    mean,         ///< mean curvature by colour
    k1,           ///< the larger principal curvature by colour
    k2,           ///< the smaller one
    absolute,     ///< sum of the absolute values of both, by colour
    section,      ///< curvature of normal sections along parallel planes, by colour
    radius,       ///< smallest radius of curvature by colour, on a logarithmic scale
    below_radius, ///< where the smallest radius is below a given one
    distortion,   ///< how glass turns lines of sight, by colour, and a grid behind it
    isoparms,     ///< isoparametric lines of each patch, patch borders and borders of faces
    patches       ///< patches in colours of their own
};

/// "zebra", "isophote", "highlight", "draft", "curvature:gauss", "curvature:mean", "curvature:k1",
/// "curvature:k2", "curvature:absolute", "curvature:section", "radius", "below-radius",
/// "distortion", "isoparms", "patches"
std::string_view name_of(AnalysisMode look);
/// All modes, in the order of their declaration.
const std::vector<AnalysisMode>& every_look();
/// True for the modes that show a curvature by colour.
bool is_curvature(AnalysisMode look);
/// True for the modes whose colours stand for numbers on a scale.
bool has_scale(AnalysisMode look);

/// A mode, and the curvature of full colour where the user states it.
struct StatedLook {
    AnalysisMode mode = AnalysisMode::zebra; ///< the mode
    std::optional<double> full{};            ///< 1/mm, above 0; of curvatures alone
};

/// The mode of a text: its name, which "=C" may follow with the curvature C of full colour. Throws
/// FieldError for another text.
StatedLook look_from(const std::string& text);

/// Scale of a picture's colours: by hand, or else by the values that the picture shows.
struct AnalysisScale {
    std::optional<ValueRange> range{}; ///< by hand, in the unit of the mode
    /// Percent of the body's picture whose colours are not saturated, above 0 and at most 100; of
    /// the draft angle nullopt is 5 times the minimum draft.
    std::optional<double> percentile{};
};

/// Settings of an analysis picture. Each mode uses its own.
struct AnalysisOptions {
    Vec3 pull{0, 0, 1}; ///< direction in which the tool is pulled off; finite, not 0
    double draft = 3;   ///< degrees, 0 to 90: draft angles from 0 to this are too small
    double radius = 1;  ///< mm, above 0: smaller ones are marked by below_radius
    std::optional<Image> sections{};   ///< section_curvatures(), which the mode `section` needs
    std::optional<Image> deviations{}; ///< glass_deviations(), which the mode `distortion` needs
    AnalysisScale scale{};             ///< of modes for which has_scale()
    /// Number in the film of a face that is no part of the body: it has no colours and no part in
    /// percentiles. In films of render_view it is 0, the ground.
    std::optional<int> ground{};
};

} // namespace keiko
