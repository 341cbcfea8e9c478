#pragma once

#include "keiko/geometry/rays/visibility.h"
#include "keiko/light/tubes/lamp_width.h"
#include "keiko/light/tubes/tube_lamp.h"
#include "keiko/math/interval_set.h"

#include <span>
#include <vector>

namespace keiko {

/// Visible part of a light from a point.
struct LightVisibility {
    /// Visible parts of a tube's axis; for any other source the whole if any of it is visible, else
    /// empty.
    IntervalSet axis{};
    /// Visible share, 0 to 1, of a lamp's light on the surface, relative to that with occlusion by
    /// lamps alone; for models that need the whole width.
    double share = 1;
    /// Visible share, 0 to 1, of the light of the cap that faces the point, for the same models.
    double cap = 1;

    bool operator==(const LightVisibility&) const = default;
};

/// Accuracy of the penumbrae.
struct PenumbraOptions {
    double tolerance = 0; ///< of a lamp's projected solid angle, as bright all over as at its best
    TubeShape shape = TubeShape::cylinder; ///< of all lamps, across their width
    bool axes = false;                     ///< visible parts of axes are queried as well
    /// Widest spacing between lines of equal visibility, of half the width, by the angle around a
    /// cylinder. Smaller occluders may be missed between them unless they are searched for.
    double widest_spacing = 1;
    /// True if the width is cut where outlines turn that hide more than the tolerance between
    /// lines. Lines then agree only if they do for each visible part.
    bool between_lines = false;
};

/// Visible shares of a row's lamps from `point` with unit `normal`: 0 to 1, of their projected
/// solid angles, weighted by their light. They are of the whole width of each lamp
/// (docs/theory/visibility.md#the-width-of-a-lamp). The axis alone misses them by 2e-3 in ordinary
/// places, by 2 % where an occluder's edge runs along the lamp. `row`: parallel lamps of one
/// diameter, in order.
///
/// One ray suffices for a lamp if all of it above the horizon is proved to have one visibility.
/// Otherwise sub-axes across the lamp are traced, more of them until the estimated error is below
/// the tolerance. `hiding`: empty, or for each lamp others of the row that hide some of it; the
/// share is relative to the rest.
std::vector<LightVisibility> seen_tubes(std::span<const TubeLamp> row, const Vec3& point,
                                        const Vec3& normal, const Visibility& visible,
                                        const PenumbraOptions& options,
                                        std::span<const std::vector<OccludingTube>> hiding = {});

/// Visible share, 0 to 1, of the light of the cap that faces `point` with unit `normal`, relative
/// to all of it above the horizon. It is sampled by chords of the cap's disc along the horizon,
/// closer where the visibilities of neighbours are not in line, to about `tolerance`. Occluders
/// that lie between the first 33 chords and hide none of them are missed. 1 if no cap faces the
/// point.
double seen_share_of_cap(const TubeLamp& lamp, const Vec3& point, const Vec3& normal,
                         const Visibility& visible, double tolerance);

} // namespace keiko
