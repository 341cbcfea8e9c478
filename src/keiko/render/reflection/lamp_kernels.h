#pragma once

#include "keiko/light/tubes/c_plane.h"
#include "keiko/render/reflection/reflected_grid.h"
#include "keiko/simd/level.h"

#include <cstdint>

namespace keiko {

/// A row of lamps in the form that the kernels read.
struct StripeRow {
    const CPlaneFrame& frame; ///< of the row's plane
    MirrorModel look;         ///< flat or tube
};

/// Reflections of a row of lamps in up to 8 pixels that follow each other in a row of a picture;
/// their reflected rays and those of their four neighbours have differentials.
struct LampCoverageBatch {
    static constexpr std::size_t capacity = 8; ///< most pixels of a batch
    /// One value of each pixel.
    template <class T>
    using Lanes = std::array<T, capacity>;

    // Sets of pixels, a bit each.
    std::uint32_t meets = 0; ///< the centre's ray meets the plane
    /// Proved to reflect no lamp: misses_lamps() of cone_of().
    std::uint32_t missed = 0;
    std::uint32_t bounded = 0; ///< ImageBend has a value
    std::uint32_t points = 0;  ///< the footprint is a point
    // Values of those that meet the plane.
    alignas(64) Lanes<double> t; ///< as in CPlaneHit
    alignas(64) Lanes<double> u; ///< as in CPlaneHit
    alignas(64) Lanes<double> v; ///< as in CPlaneHit
    /// ImageBend, for pixels not `missed` unless thorough.
    alignas(64) Lanes<double> bend;
    alignas(64) Lanes<double> residual; ///< ReflectedFootprint::residual(), mm; if thorough
    alignas(64) Lanes<double> coverage; ///< LampCoverage::coverage, for pixels not `missed`
};

/// Number of parts a side of a bent pixel, and the extent of its rays.
struct SquareParts {
    int side = 1;     ///< parts a side; the pixel has side^2
    double t_max = 0; ///< parameter beyond which rays meet no lamp
};

/// Kernels of mirror_of() for a row of lamps, compiled for one instruction set, for a batch of
/// pixels or of parts of one at a time. The results are those of the formulas for one pixel, to the
/// bit on every instruction set; a mean over parts is summed up in another order.
struct LampKernels {
    /// Coverage of the pixels from `place` on; rows of the picture are `width` long.
    void (*look)(const StripeRow&, const ReflectedRays&, std::size_t place, std::size_t width,
                 bool thorough, LampCoverageBatch&);
    /// The mean coverage over the parts of one pixel, like RigPlanes::luminance() of them.
    double (*coverage_of_parts)(const StripeRow&, const ReflectedRays&, std::size_t place,
                                std::size_t width, const SquareParts&);
};

/// Coverage of one pixel that end_coverage() or the like has to tell, by the numbers of its hit (t,
/// u, v, direction) and of its footprint (dx, dy, descent).
double coverage_of_numbers(const StripeRow& row, const double numbers[12]);

KEIKO_OF_EVERY_LEVEL(LampKernels, lamp_kernels)

/// Kernels of a level that this processor has.
LampKernels lamp_kernels(SimdLevel level = widest_simd_level());

} // namespace keiko
