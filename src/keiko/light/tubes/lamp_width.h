#pragma once

#include "keiko/geometry/visibility/visibility.h"
#include "keiko/light/tubes/cylinder_irradiance.h"
#include "keiko/light/tubes/tube_lamp.h"

#include <span>
#include <vector>

namespace keiko {

/// Shape of a lamp across its width that faces the point: the tube itself, or the rectangle through
/// its axis.
enum class TubeShape { cylinder, rectangle };

/// A line of a lamp parallel to its axis: where the half-plane at the wedge angle psi, through the
/// line parallel to the axis through the point, cuts its near side.
struct SubAxis {
    double cosine = 1, sine = 0; ///< of psi
    double r = 0;                ///< mm, from the point
    double weight = 0;           ///< d psi by the place across
};

/// A lamp across, as a point sees it: places from -1 to 1, sideways.
class LampWidth {
public:
    /// `hiding`: other tubes, of the lamp's radius and ends, that may hide some of it; only looked
    /// at.
    LampWidth(const TubeView& view, const Vec3& point, TubeShape shape,
              std::span<const OccludingTube> hiding)
        : view_(view), point_(point), shape_(shape), hiding_(hiding) {}

    SubAxis sub_axis(double place) const {
        return shape_ == TubeShape::cylinder ? on_tube(place) : on_rectangle(place);
    }
    Segment line_of(const SubAxis& axis) const;
    /// Whether all of the axis is seen through the middle line: where the point is between the
    /// lamp's ends, so that only the tube is between them.
    bool middle_tells_axis() const;
    /// What is seen of the axis where that is seen of the middle line, if it tells.
    IntervalSet of_axis(const IntervalSet& middle) const;
    /// Projected solid angle, by the wedge angle, of a part of a sub-axis: from t = `begin` to
    /// `end`, without what other tubes hide.
    double lit(const SubAxis& axis, double begin, double end) const;
    /// From -1 to 1, with the places at which another tube begins or ends to hide some.
    std::vector<double> cuts() const;
    /// In a way from the point, at right angles to the lamp; beyond [-1, 1] beside it.
    double place_in(const Vec3& way) const;

private:
    double place_of(double psi) const;
    SubAxis on_tube(double place) const;
    SubAxis on_rectangle(double place) const;

    TubeView view_;
    Vec3 point_;
    TubeShape shape_;
    std::span<const OccludingTube> hiding_;
};

} // namespace keiko
