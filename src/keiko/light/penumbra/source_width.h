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
    double place = 0;            ///< across, of sources whose lines are known by it
};

/// The width of a source viewed from a point: lines at places from -1 to 1, by rising wedge angle.
/// They are parallel, or meet in a point of the line that bounds all half-planes.
class SourceWidth {
public:
    virtual ~SourceWidth() = default;
    /// Line at a place from -1 to 1.
    virtual SubAxis sub_axis(double place) const = 0;
    /// Ends of a line in mm.
    virtual Segment line_of(const SubAxis& axis) const = 0;
    /// A prism around all lines, along the line that bounds the half-planes.
    virtual Prism around() const {
        const auto line = [&](double place) { return line_of(sub_axis(place)); };
        return {line(-1), line(0), line(0), line(1)};
    }
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
