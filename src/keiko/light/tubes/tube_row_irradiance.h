#pragma once

#include "keiko/light/tubes/c_plane.h"
#include "keiko/light/tubes/cylinder_irradiance.h"
#include "keiko/light/tubes/tube_lamp.h"
#include "keiko/math/interval_set.h"

#include <vector>

namespace keiko {

/// Light of the lamps of a C-plane at a point. If lamps of the row hide each other, the models
/// automatic, picture, preview, strip and cylinder use the cylinders without their hidden parts
/// (docs/theory/luminance.md#lamps-that-hide-each-other). The models nishita, rectangle and line
/// count every lamp in full, as [NishitaTubes] does.
class TubeRowIrradiance {
public:
    /// The frame must outlive this.
    TubeRowIrradiance(const CPlaneFrame& frame, const Vec3& point, const Vec3& normal,
                      TubeModel model);

    /// Projected solid angle in sr of the visible part of one lamp, 0 to lamps - 1 by rising v: the
    /// illuminance in lx for a luminance of 1 cd/m2. `visible` holds the parts of its axis that are
    /// not hidden by anything other than lamps.
    double solid_angle(int lamp, const IntervalSet& visible) const;

    /// True if some lamp of the row is before another one, viewed from the point.
    bool overlapping() const { return !wedges_.empty(); }
    /// The lamps of the row that may hide some of one from the point.
    std::vector<OccludingTube> hiding_tubes(int lamp) const;

private:
    /// A lamp in the cross-section through the point: the wedge that its endless tube covers.
    struct Wedge {
        double angle = 0;    ///< radians from the perpendicular to the plane, towards rising v
        double half = 0;     ///< radians
        double distance = 0; ///< mm, of the axis
    };
    static bool overlap(const Wedge& a, const Wedge& b);
    Wedge wedge_of(int lamp) const;
    bool surely_apart() const;
    const CPlaneFrame& frame_;
    Vec3 point_, normal_;
    Vec3 at_; ///< the point in the plane's frame
    TubeModel model_;
    std::vector<Wedge> wedges_; ///< of all lamps if some overlap, else none
};

} // namespace keiko
