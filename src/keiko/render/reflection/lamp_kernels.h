#pragma once

#include "keiko/light/tubes/c_plane.h"
#include "keiko/render/reflection/reflected_grid.h"

#include <cstdint>

namespace keiko {

/// A row of lamps as the kernels read it.
struct StripeRow {
    const CPlaneFrame& frame;
    MirrorModel look; ///< flat or tube
};

/// How pixels beside each other mirror a row of lamps, of up to 8 that follow each other in a row
/// of a picture; their reflected rays and those of their four neighbours have differentials.
struct LampCoverageBatch {
    static constexpr std::size_t capacity = 8;
    template <class T>
    using Lanes = std::array<T, capacity>;

    // Sets of pixels, a bit each.
    std::uint32_t meets = 0; ///< the centre's ray meets the plane
    std::uint32_t missed =
        0; ///< proved to see no lamp: misses_lamps() of ReflectedFootprint::bundle()
    std::uint32_t bounded = 0; ///< footprint_nonlinearity() has a value
    std::uint32_t points = 0;  ///< the footprint is a point
    // Of those that meet the plane.
    alignas(64) Lanes<double> t, u, v; ///< as CPlaneHit
    alignas(64)
        Lanes<double> bend; ///< footprint_nonlinearity(), for pixels not `missed` unless thorough
    alignas(64) Lanes<double> residual; ///< ReflectedFootprint::misfit(), mm; if thorough
    alignas(64) Lanes<double> coverage; ///< LampCoverage::coverage, for pixels not `missed`
};

/// Parts a side of a bent pixel, and how far its rays go.
struct SquareParts {
    int side = 1;
    double t_max = 0;
};

/// Kernels of mirror_of() for a row of lamps, made for one instruction set, for a vector of pixels
/// or of parts of one at a time. The results are the same to within rounding, in the same order
/// whatever pixels stand beside each other.
struct LampKernels {
    const char* name; ///< of the instruction set
    /// Coverage of the pixels from `place` on; rows of the picture are `width` long.
    void (*look)(const StripeRow&, const ReflectedRays&, std::size_t place, std::size_t width,
                 bool thorough, LampCoverageBatch&);
    /// The mean coverage over the parts of one pixel, as RigPlanes::luminance() of them.
    double (*coverage_of_parts)(const StripeRow&, const ReflectedRays&, std::size_t place,
                                std::size_t width, const SquareParts&);
};

/// The widest that this processor has.
LampKernels lamp_kernels();

} // namespace keiko
