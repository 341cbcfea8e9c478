#pragma once

#include "keiko/light/tubes/c_plane.h"
#include "keiko/math/interval_set.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace keiko {

/// A straight diffuse tube: `luminance` is the same in every direction.
struct TubeLamp {
    Vec3 a{0}, b{0};            ///< ends of the axis, mm
    double diameter = 0;        ///< mm
    Rgb luminance;              ///< cd/m2 of the lateral surface
    bool luminous_caps = false; ///< true if the end discs shine alike; else they are dark
};

/// Lamp `index`, 0 to lamps - 1, of the row.
inline TubeLamp lamp_of(const CPlaneFrame& frame, int index, const Rgb& luminance) {
    const double across = frame.axis(index);
    return {frame.at(0, across), frame.at(frame.length, across), frame.diameter, luminance,
            frame.luminous_caps};
}

/// All lamps of a C-plane by rising v.
inline std::vector<TubeLamp> lamps_of(const CPlane& plane) {
    const CPlaneFrame frame(plane);
    std::vector<TubeLamp> lamps;
    lamps.reserve(static_cast<std::size_t>(frame.lamps));
    for (int i = 0; i < frame.lamps; ++i) lamps.push_back(lamp_of(frame, i, plane.luminance));
    return lamps;
}

/// A lamp viewed from a surface element (docs/theory/luminance.md#a-tube): the frame in which every
/// model of the lamp integrates. Positions along the axis, called x, count in mm from the foot of
/// the point.
struct TubeView {
    Vec3 along;            ///< unit vector of the axis, a to b
    Vec3 towards;          ///< unit vector from the axis to the point
    Vec3 sideways;         ///< along x towards
    double distance = 0;   ///< of the point from the axis line, > radius
    double x_a = 0;        ///< of end a; end b lies at x_a + length
    double length = 0;     ///< mm, of the axis
    double radius = 0;     ///< mm
    double n_along = 0;    ///< components of the surface normal
    double n_lamp = 0;     ///< towards the axis: -N.towards
    double n_sideways = 0; ///< along `sideways`
    Vec3 normal;           ///< unit vector of the surface element

    /// Position x in mm at a parameter of the axis: 0 at end a, 1 at end b.
    double x_at(double t) const { return x_a + t * length; }
    /// Diameter over distance, on which the models' errors depend.
    double ratio() const { return 2 * radius / distance; }
};

/// View of a lamp; nullopt if the lateral surface is not visible or the lamp has no extent. It is
/// not visible from inside the glass, from the axis line, or close to that line beyond an end,
/// where only the dark cap shows.
inline std::optional<TubeView> view_of(const TubeLamp& lamp, const Vec3& point,
                                       const Vec3& normal) {
    TubeView view;
    view.length = (lamp.b - lamp.a).length();
    view.radius = lamp.diameter / 2;
    view.along = (lamp.b - lamp.a) / view.length;
    const Vec3 from_a = point - lamp.a;
    view.x_a = -from_a.dot(view.along);
    const Vec3 off_axis = from_a + view.along * view.x_a;
    view.distance = off_axis.length();
    if (!(view.radius > 0) || !(view.distance > view.radius)) return {};
    view.towards = off_axis / view.distance;
    view.sideways = view.along.cross(view.towards);
    view.normal = normal;
    view.n_along = normal.dot(view.along);
    view.n_lamp = -normal.dot(view.towards);
    view.n_sideways = normal.dot(view.sideways);
    return view;
}

/// A visible part of a lamp, from x = begin to end; `begins` and `ends` state whether these are the
/// lamp's own ends. Where a shadow cuts the lamp there is no rim, the cut runs radially.
struct VisiblePart {
    double begin = 0, end = 0;       ///< x, mm from the foot of the point
    bool begins = true, ends = true; ///< false where a shadow cuts the lamp
};

/// Sum of `f` over the parts of a lamp that belong to visible intervals of its axis, parameters 0
/// to 1.
template <class F>
auto sum_over_parts(const TubeView& view, const IntervalSet& visible, const F& f) {
    decltype(f(VisiblePart{})) sum{};
    for (const ParameterInterval& interval : visible) {
        const double begin = std::max(interval.begin, 0.0), end = std::min(interval.end, 1.0);
        if (begin < end)
            sum += f(VisiblePart{view.x_at(begin), view.x_at(end), begin == 0, end == 1});
    }
    return sum;
}

} // namespace keiko
