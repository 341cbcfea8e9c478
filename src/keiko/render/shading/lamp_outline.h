#pragma once

#include "keiko/geometry/rays/contour_arc.h"
#include "keiko/geometry/rays/visibility.h"
#include "keiko/math/bounds.h"

#include <functional>
#include <vector>

namespace keiko {

/// The sides of a luminous body that shine.
enum class LampSides {
    of_solid,   ///< the outside of a closed body
    outer_side, ///< the outer sides of sheets, which their inner sides hide
    both_sides  ///< of sheets
};

/// Directions in which a point sees a luminous body shine, as what the body hides of lines behind
/// it. They are known from the arcs of its outlines: sheets are counted along a line from arc to
/// arc, and rays decide where the count does not or the arcs are not complete. For one thread.
class LampOutline final : public Visibility {
public:
    /// Sides of the sheets that a ray from the point in a direction passes, the nearest first;
    /// true for outer ones.
    using SidesAlong = std::function<std::vector<bool>(const Vec3& direction)>;
    /// `arcs`: as those of BodyContour::arcs_from; `box`: around the body.
    LampOutline(const Vec3& point, ContourArcs arcs, LampSides shining, SidesAlong sides_along,
                const Box3& box);

    using Visibility::intervals;
    IntervalSet intervals(const Segment& segment) const override;
    /// Places where an arc turns, or ends at a corner. `rule` does not matter.
    std::vector<CriticalSlice> turns(const Prism& prism, const TurnRule& rule) const override;

private:
    /// Place on a line where sheets begin or end.
    struct Change {
        double at; ///< parameter of the line
        SheetCount more;
    };
    std::vector<Change> changes_along(const Segment& segment) const;
    /// Parts of a line from which the body shines. `sheets`: at its begin; unless they are sound,
    /// rays decide between all changes.
    std::vector<ParameterInterval> bright_parts(const Segment& segment, std::vector<Change> changes,
                                                SheetCount sheets, bool is_sound) const;
    /// Bright parts of a stretch without arcs. Where outer and inner sides are met, they are
    /// compared at both ends and in the middle, as sheets that pass through one another change
    /// their order.
    std::vector<ParameterInterval> bright_in(const Segment& segment,
                                             const ParameterInterval& stretch,
                                             const SheetCount& sheets, bool is_sound) const;
    /// Numbers of sheets in the direction of a place.
    SheetCount sheets_towards(const Vec3& place) const;
    /// True if the body shines from the direction of a place.
    bool shines_from(const Vec3& place) const;
    bool shines_from(const Vec3& place, const SheetCount& sheets) const;

    Vec3 point_;
    ContourArcs arcs_;
    LampSides shining_;
    SidesAlong sides_along_;
    bool is_far_; ///< the body appears within some 75 degrees of a direction
};

} // namespace keiko
