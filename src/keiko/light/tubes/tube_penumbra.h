#pragma once

#include "keiko/geometry/visibility/visibility.h"
#include "keiko/light/tubes/lamp_width.h"
#include "keiko/light/tubes/tube_lamp.h"
#include "keiko/math/interval_set.h"

#include <span>
#include <vector>

namespace keiko {

/// Visible part of a light from a point.
struct LightVisibility {
    /// Of a lamp's axis; of a source without extent the whole where it is seen, else nothing.
    IntervalSet axis{};
    /// 0 to 1, of what a lamp brings to the surface where nothing but lamps hides any of it; of
    /// models that ask for the whole width.
    double share = 1;
    /// 0 to 1, of what the cap that faces the point brings, of the same models.
    double cap = 1;

    bool operator==(const LightVisibility&) const = default;
};

/// Accuracy of the penumbrae.
struct PenumbraOptions {
    double tolerance = 0; ///< of a lamp's projected solid angle, as bright all over as at its best
    TubeShape shape = TubeShape::cylinder;
    bool axes = false; ///< what is seen of axes is asked for as well
    /// Of half the width, by the angle around a cylinder: lines that all see the same are no
    /// farther apart than this. What hides less may be missed between them unless it is looked for.
    double widest_gap = 1;
    /// The width is cut where outlines turn that hide more than the tolerance between lines, and
    /// lines agree only if they do of each part that is seen.
    bool between_lines = false;
};

/// Visible shares of a row's lamps from `point` with unit `normal`: 0 to 1, of their projected
/// solid angles, weighed as they light. They are of the whole width of each lamp
/// (docs/theory/visibility.md#the-width-of-a-lamp); the axis alone misses them by 2e-3 in ordinary
/// places, by 2 % where an occluder's edge runs along the lamp. `row`: parallel lamps of one
/// diameter, in order. One ray answers for a lamp of which all above the horizon is proved to be
/// seen alike; else sub-axes across the lamp do, more of them until the estimated error is below
/// the tolerance. `hiding`: empty, or for each lamp others of the row that hide some of it; the
/// share is of what they leave.
std::vector<LightVisibility> seen_tubes(std::span<const TubeLamp> row, const Vec3& point,
                                        const Vec3& normal, const Visibility& visible,
                                        const PenumbraOptions& options,
                                        std::span<const std::vector<OccludingTube>> hiding = {});

} // namespace keiko
