#pragma once

#include "keiko/math/vec.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace keiko {

/// Numbers of sheets of a surface, by the side that they turn to a viewpoint.
struct SheetCount {
    int front = 0; ///< outer sides
    int back = 0;  ///< inner sides

    SheetCount& operator+=(const SheetCount& o) {
        front += o.front, back += o.back;
        return *this;
    }
    /// Times a factor.
    SheetCount operator*(int factor) const { return {front * factor, back * factor}; }
    bool operator==(const SheetCount&) const = default;
};

/// A place in [0, 1] where a quadratic polynomial changes its sign; zero counts as above.
struct ArcRoot {
    double t = 0;
    bool rises = true; ///< to zero or above
};

/// A piece of the outline of a surface as a point sees it, as a conic section of directions. It is
/// (1 - t)^2 begin + 2 t (1 - t) middle + t^2 end, 0 <= t <= 1 [PieglTiller1997, section 7.3]; that
/// is exact for silhouettes of quadrics, circles and lines.
struct ContourArc {
    Vec3 begin{0}, middle{0}, end{0}; ///< control directions from the viewpoint, of any lengths
    /// Sheets on the left of it less those on the right. Left of a direction d on an arc along a
    /// vector w is d x w.
    SheetCount left{};
    bool turns_at_begin = true, turns_at_end = true; ///< what follows there is not smooth

    /// Direction at t, of any length.
    Vec3 at(double t) const {
        return begin * ((1 - t) * (1 - t)) + middle * (2 * t * (1 - t)) + end * (t * t);
    }
    /// The part from one parameter to a greater one; it turns at ends that are not the arc's.
    ContourArc part(double from, double to) const;
    /// Places where the directions cross the plane with a normal through the viewpoint, at most
    /// two. Arcs that share an end are crossed there once.
    struct Crossings {
        std::array<ArcRoot, 2> of{};
        std::size_t count = 0;

        const ArcRoot* begin() const { return of.data(); }
        const ArcRoot* end() const { return of.data() + count; }
    };
    Crossings crossings(const Vec3& normal) const;
    /// Parameter of the arc's direction nearest to one beside it, along the arc; nullopt beyond its
    /// ends.
    std::optional<double> nearest(const Vec3& direction) const;
    /// Angle, rad, between a direction beside the arc and the arc; infinite beyond its ends.
    double angle_off(const Vec3& direction) const;
    /// Parameters in [0, 1] where the arc's angle about an axis, from `ahead` to `across`, is
    /// extreme.
    Crossings extremes(const Vec3& ahead, const Vec3& across) const;
};

/// The outlines of a surface from one point.
struct ContourArcs {
    std::vector<ContourArc> all;
    bool are_complete = true; ///< false if some could not be separated
};

/// Arc through three directions, tangent to the planes with these normals at its ends. Where no
/// conic section is it is a parabola through them, whatever the planes.
ContourArc arc_through(const Vec3& begin, const Vec3& through, const Vec3& end,
                       const Vec3& begin_plane, const Vec3& end_plane);

} // namespace keiko
