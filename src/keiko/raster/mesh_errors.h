#pragma once

#include "keiko/base/export.h"

#include <array>
#include <cstddef>

namespace KEIKO_API keiko {

/// Share of a pixel by which lamps are off where the pixel counts as wrong: a step of brightness
/// that an eye sees beside its neighbours.
constexpr double wrong_coverage = 0.1;
/// Share beyond which the pixel counts as reversed: it shows a lamp for the gap beside it, or a
/// gap.
constexpr double reversed_coverage = 0.5;

/// Quantiles of sizes; 0 of none.
struct SizeQuantiles {
    double median = 0;  ///< half of them are smaller
    double p99 = 0;     ///< 99 % are smaller
    double largest = 0; ///< of all
};

/// Pixels in which a mesh shows other faces than there are.
struct FacePixels {
    std::size_t all = 0;    ///< everywhere
    std::size_t inside = 0; ///< of them, those whose 8 neighbours all show one face in truth
};

/// Errors of what a mesh shows of a surface in one view.
struct MeshErrors {
    std::size_t body = 0;     ///< pixels that show the body in truth
    std::size_t compared = 0; ///< of these, of the same face in both, where one mirrors lamps
    std::size_t wrong = 0;    ///< of these, coverage off by more than wrong_coverage
    std::size_t reversed = 0; ///< of these, coverage off by more than reversed_coverage
    FacePixels missed{};      ///< pixels of the body in which the mesh shows nothing
    FacePixels added{};       ///< pixels beside the body in which the mesh shows something
    FacePixels other_face{};  ///< pixels in which both show faces, but not the same
    // Sizes are of the compared pixels in which the surface meets a row of lamps.
    SizeQuantiles pixels{};   ///< displacement of the mirrored lamps in the picture, px
    SizeQuantiles on_part{};  ///< the same across the line of sight at the surface, mm
    SizeQuantiles at_lamps{}; ///< the same at the lamps, mm
    SizeQuantiles normal{};   ///< angle between the normals, seconds of arc
};

/// Second differences of luminance from pixel to pixel across borders of facets, their 99th
/// percentile relative to the brightest luminance: an eye sees them as Mach bands [Ratliff1965].
struct FacetBands {
    std::size_t places = 0;        ///< borders that were measured, in rows and columns of pixels
    double truth = 0;              ///< of the exact surface at the same places
    std::array<double, 3> mesh{0}; ///< by MeshShading
};

} // namespace keiko
