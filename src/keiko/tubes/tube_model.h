#pragma once

namespace keiko {

/// How a lamp is taken for what it is not, from the seed paper to exact (physics 2). Errors are
/// those of a lamp in ordinary position, by d/D, its diameter over its distance.
enum class TubeModel {
    automatic, ///< strip up to d/D = 0.018, where its error is 1e-4 at most; cylinder beyond
    picture,   ///< strip up to d/D = 0.2, where its error is 2.3e-3; cylinder beyond
    preview,   ///< the same, and shadows cut the lamp along its axis alone (physics 2.8)
    seed,      ///< [003] eq. (1) with its indices corrected (2.1): -0.27 d/D
    rectangle, ///< the facing rectangle, exactly (2.2): -0.27 d/D
    line,      ///< the limit of a thin lamp (2.4): -0.26 d/D
    strip,     ///< mean-rim strip (2.3): -0.058 (d/D)^2, aside and aslant up to 0.28
    cylinder   ///< the tube itself by quadrature (2.5): below 1e-9
};

/// How lamps look in a mirror (physics 3.3).
enum class TubeLook {
    tube, ///< round tubes in closed form: strips of their apparent width, rims at the ends
    flat, ///< the flat strips of the seed paper ([003])
    exact ///< the capped cylinders; a pixel as the mean over a grid of rays
};

} // namespace keiko
