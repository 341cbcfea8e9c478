#pragma once

#include "keiko/light/penumbra/source_width.h"
#include "keiko/light/tubes/cylinder_irradiance.h"
#include "keiko/light/tubes/tube_lamp.h"

#include <span>
#include <vector>

namespace keiko {

/// Shape of a lamp across its width that faces the point: the tube itself, or the rectangle through
/// its axis.
enum class TubeShape {
    cylinder, ///< the near side of the tube, up to its outline
    rectangle ///< as wide as the diameter, at right angles to the direction to the point
};

/// The width of a lamp viewed from a point: the lines are parallel to its axis.
class LampWidth final : public SourceWidth {
public:
    /// `hiding`: other tubes, of the lamp's radius and ends, that may hide some of it; a reference
    /// is kept.
    LampWidth(const TubeView& view, const Vec3& point, TubeShape shape,
              std::span<const OccludingTube> hiding)
        : view_(view), point_(point), shape_(shape), hiding_(hiding) {}

    /// Line at a place from -1 to 1. On a cylinder the place times pi / 2 is the angle around it.
    SubAxis sub_axis(double place) const override {
        return shape_ == TubeShape::cylinder ? on_tube(place) : on_rectangle(place);
    }
    /// Ends of a line in mm, in the order of the lamp's: as long as the axis and parallel to it.
    Segment line_of(const SubAxis& axis) const override;
    /// True if all of the axis is visible through the middle line: the point is between the lamp's
    /// ends, so that only the tube itself lies between.
    bool middle_tells_axis() const;
    /// Visible parts of the axis from those of the middle line, if that determines them.
    IntervalSet of_axis(const IntervalSet& middle) const;
    /// Projected solid angle, by the wedge angle, of a part of a sub-axis from t = `begin` to
    /// `end`, without the parts that other tubes hide.
    double lit(const SubAxis& axis, double begin, double end) const override;
    /// Places from -1 to 1, with those at which another tube begins or ends to hide some.
    std::vector<double> cuts() const override;
    /// Place in a direction from the point, at right angles to the lamp.
    double place_in(const Vec3& way) const override;

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
