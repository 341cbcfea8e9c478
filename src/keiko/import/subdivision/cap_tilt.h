#pragma once

#include "keiko/math/vec.h"

#include <vector>

namespace keiko::subdivision {

/// An irregular vertex of the last level where the limit surface has a normal.
struct IrregularPoint {
    Vec3 position{0}, normal{0};
};

/// What turns a cap at one of its corners into the limit surface's tangent plane there, and
/// leaves its border to the exact patches as it is: OpenSubdiv's Gregory patches come near that
/// plane only. Caps that share a border near the corner are moved alike along it.
struct CapTilt {
    int corner = -1; ///< anticlockwise from u = v = 0; -1: none
    Vec3 normal{0};
    double slope_x = 0, slope_y = 0; ///< of the cap along the two borders from the corner

    /// To be added to the cap at (u, v).
    Vec3 offset(double u, double v, bool triangle) const;
};

/// Finds irregular points by their place.
class IrregularPoints {
public:
    explicit IrregularPoints(const std::vector<IrregularPoint>& points);

    /// The one within `reach` whose normal is nearest to `normal`, if any.
    const IrregularPoint* find(const Vec3& place, const Vec3& normal, double reach) const;

private:
    std::vector<std::pair<double, IrregularPoint>> sorted_; ///< by place along a direction
};

} // namespace keiko::subdivision
