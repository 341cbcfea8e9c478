#pragma once

#include "keiko/patch/boundary_curves.h"
#include "keiko/patch/seam.h"

#include <algorithm>
#include <optional>

namespace keiko {

/// What the two sides of a seam are to each other at one place; world coordinates.
struct SeamPoint {
    double t = 0, s = 0;         ///< parameters of the curves of the sides a and b
    Vec3 place{0};               ///< on side a
    double gap = 0;              ///< mm, to the nearest point of side b
    std::optional<double> angle; ///< degrees, 0 smooth to 180 folded back; needs both normals
    double curvature_a = 0, curvature_b = 0; ///< 1/mm, across the seam, normals on one side
};

/// Looks at a seam on its exact geometry.
class SeamProbe {
public:
    SeamProbe(const BoundaryCurves& curves, const Seam& seam)
        : a_(curves.curve(seam.a)), b_(curves.curve(seam.b)), seam_(seam) {}

    double begin() const { return seam_.a.begin; }
    double end() const { return seam_.a.end; }
    /// The seam at parameter t of side a; `s_guess` is where side b is thought to face it.
    SeamPoint at(double t, double s_guess) const;
    /// The same with a guess in proportion.
    SeamPoint at(double t) const;
    /// mm, of side a.
    double length() const { return a_.length(seam_.a.begin, seam_.a.end); }

    /// The larger number of patches that either side runs through: where it may change its ways.
    int patch_count() const { return std::max(a_.patch_count(), b_.patch_count()); }

private:
    SurfaceCurve a_, b_;
    Seam seam_;
};

} // namespace keiko
