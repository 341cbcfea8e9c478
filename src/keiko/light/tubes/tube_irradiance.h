#pragma once

#include "keiko/light/tubes/c_plane.h"
#include "keiko/light/tubes/cylinder_irradiance.h"
#include "keiko/light/tubes/tube_lamp.h"
#include "keiko/math/interval_set.h"

#include <vector>

namespace keiko {

/// Projected solid angles in sr of a part of a lamp approximated by a flat shape, clipped by the
/// tangent plane. TubeModel states their errors
/// (docs/theory/luminance.md#the-ladder-of-approximations).

/// Facing rectangle by [NishitaTubes, eq. 1] with its indices corrected. As in the paper, the
/// tangent plane clips the axis only.
double nishita_solid_angle(const TubeView& view, const VisiblePart& part);

/// The rectangle through the axis that faces the point, as wide as the lamp.
double rectangle_solid_angle(const TubeView& view, const VisiblePart& part);

/// A strip that covers the angle of the tube, stretched by the mean bulge pi R / 4 of the rims
/// towards the point.
double strip_solid_angle(const TubeView& view, const VisiblePart& part);

/// The axis as a line that shines with the cosine of the angle to its perpendicular, in closed
/// form.
double line_solid_angle(const TubeView& view, const VisiblePart& part);

/// Projected solid angle in sr of the visible lateral surface of a lamp from `point` with unit
/// `normal`, and of its cap if that shines: the illuminance in lx for a luminance of 1 cd/m2.
/// `visible` holds the parts of the axis that are not hidden, parameters 0 (end a) to 1 (end b); a
/// cap is visible if its end is. The tangent plane clips by itself. It is 0 inside the glass; on
/// the line of the axis only a cap is visible.
double projected_solid_angle(const TubeLamp& lamp, const Vec3& point, const Vec3& normal,
                             const IntervalSet& visible = IntervalSet::whole(),
                             TubeModel model = TubeModel::automatic);

/// Projected solid angle in sr of the cap that faces the point; 0 if caps are dark.
double cap_solid_angle(const TubeLamp& lamp, const Vec3& point, const Vec3& normal,
                       const IntervalSet& visible = IntervalSet::whole());

/// Illuminance in lx: the projected solid angle times the lamp's luminance. Occlusion by other
/// lamps is not included: TubeRowIrradiance does.
inline Rgb irradiance(const TubeLamp& lamp, const Vec3& point, const Vec3& normal,
                      const IntervalSet& visible = IntervalSet::whole(),
                      TubeModel model = TubeModel::automatic) {
    return lamp.luminance * projected_solid_angle(lamp, point, normal, visible, model);
}

/// True if the whole lamp lies below the tangent plane, so that its visibility need not be queried.
inline bool below_horizon(const TubeLamp& lamp, const Vec3& point, const Vec3& normal) {
    const double radius = lamp.diameter / 2;
    return normal.dot(lamp.a - point) <= -radius && normal.dot(lamp.b - point) <= -radius;
}

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
