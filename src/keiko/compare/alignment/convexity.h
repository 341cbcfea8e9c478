#pragma once

#include "keiko/geometry/bezier/bezier_patch.h"

#include <array>

namespace keiko {

/// Proves that the squared distance of a point to a piece of surface is convex over it, so that it
/// has one minimum: for every unit direction v there, |S' v|^2 > |(S - p) . S'' v v|, by bounds on
/// the control net in the frame of the mean tangents.
class Convexity {
public:
    /// Holds nowhere.
    Convexity() = default;
    explicit Convexity(const BezierPatchView& piece);

    /// Whether it is proved over `piece`, which is what this was made of or a part of that. Never
    /// at a pole.
    bool holds(const BezierPatchView& piece, const Vec3& p) const;

private:
    std::array<Vec3, 3> axes_{Vec3(0), Vec3(0), Vec3(0)}; ///< S = centre + the sum of axes times X
    double first_ = 0;                                    ///< least |S' v|, or less
    std::array<double, 3> second_{};                      ///< largest |X'' v v| of each axis
};

} // namespace keiko
