#pragma once

#include "keiko/geometry/rays/visibility.h"

#include <vector>

namespace keiko {

/// A line of a source viewed from a point: the cut of the source with the half-plane at the wedge
/// angle psi. All half-planes are bounded by the line through the point that is parallel to it.
struct SubAxis {
    double cosine = 1, sine = 0; ///< of psi
    double r = 0;                ///< mm, from the point to the line that holds it
    double weight = 0;           ///< d psi by the place across
};

/// The width of a source viewed from a point: parallel lines at places from -1 to 1, by rising
/// wedge angle.
class SourceWidth {
public:
    virtual ~SourceWidth() = default;
    /// Line at a place from -1 to 1.
    virtual SubAxis sub_axis(double place) const = 0;
    /// Ends of a line in mm. All lines have one direction.
    virtual Segment line_of(const SubAxis& axis) const = 0;
    /// Projected solid angle, by the wedge angle, of the part of the source on a line from t =
    /// `begin` to `end`, 0 to 1 along line_of().
    virtual double lit(const SubAxis& axis, double begin, double end) const = 0;
    /// Places from -1 to 1, both included and rising, between which the light of a line is smooth.
    virtual std::vector<double> cuts() const = 0;
    /// Place in a direction from the point, at right angles to the lines; beyond [-1, 1] it is
    /// beside the source.
    virtual double place_in(const Vec3& way) const = 0;
};

} // namespace keiko
