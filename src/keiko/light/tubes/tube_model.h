#pragma once

namespace keiko {

/// Models of a cylindrical lamp, from the facing rectangle [NishitaTubes, eq. 1] to the exact
/// cylinder (docs/theory/luminance.md#the-ladder-of-approximations). Errors are those of a lamp in
/// ordinary position, by d/D, its diameter over its distance.
enum class TubeModel {
    automatic, ///< strip up to d/D = 0.018, where its error is 1e-4 at most; cylinder beyond
    picture,   ///< strip up to d/D = 0.2, where its error is 2.3e-3; cylinder beyond
    preview,   ///< the same, and shadows cut the lamp along its axis alone
    nishita,   ///< [NishitaTubes, eq. 1] with its indices corrected: -0.27 d/D
    rectangle, ///< the facing rectangle, exactly: -0.27 d/D
    line,      ///< the limit of a thin lamp: -0.26 d/D
    strip,     ///< mean-rim strip: -0.058 (d/D)^2, aside and aslant up to 0.28
    cylinder   ///< the tube itself by quadrature: below 1e-9
};

/// Models of the mirror image of a row of lamps (docs/theory/luminance.md#in-mirrors).
enum class MirrorModel {
    tube, ///< round tubes in closed form: strips of their apparent width, rims at the ends
    flat, ///< the flat strips of [NishitaTubes]
    exact ///< the capped cylinders; a pixel as the mean over a grid of rays
};

} // namespace keiko
