#pragma once

#include "keiko/intersect/subpatch/sub_patch_frame.h"

#include <vector>

namespace keiko {

/// The homogeneous components of a sub-patch in its frame by powers of x and y: entry
/// i * (degree_v + 1) + j holds the coefficients of x^i y^j in (w X, w Y, w Z, w).
struct SubPatchPolynomial {
    std::vector<std::array<double, 4>> coefficients;
    /// Bound of the error of any component when evaluated by Horner's scheme in double precision
    /// within [-1, 1]^2, fused or not: by the change to powers and by using them. (What turning the
    /// control points into the frame costs is in PackedSubPatch::blur.)
    std::array<double, 4> rounding{};
};

/// Requires a regular frame.
SubPatchPolynomial sub_patch_polynomial(const BezierPatchView& sub_patch,
                                        const SubPatchFrame& frame);

} // namespace keiko
