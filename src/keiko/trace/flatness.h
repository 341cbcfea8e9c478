#pragma once

#include "keiko/patch/bezier_patch.h"

namespace keiko {

/// How far the control net of a piece of surface is from an affine map of its parameters.
struct Flatness {
    /// Largest deviation over half an edge length, across the surface as well as along it.
    /// Infinite where the mean tangents are parallel or vanish.
    double deviation = 0;
    double bend_u = 0, bend_v = 0;     ///< mm, part of it that halving u or v divides by four
    double twist = 0;                  ///< mm, part that either halving divides by two
    double length_u = 0, length_v = 0; ///< mm, mean edge lengths
};

Flatness flatness(const BezierPatchView& patch);

} // namespace keiko
