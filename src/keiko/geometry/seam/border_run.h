#pragma once

#include "keiko/base/units.h"
#include "keiko/geometry/model/closest_point.h"

#include <optional>
#include <vector>

namespace keiko {

/// Radians: borders that diverge faster than this cross or touch; they do not form a seam.
constexpr double parallel_borders = degrees_to_radians(10);
/// True if the sine of the angle between two directions is at most `sine`.
bool nearly_parallel(const Vec3& a, const Vec3& b, double sine);

/// The polylines of all borders of a loop, one after the other. The last leads back to the first.
using LoopLine = std::vector<Vec3>;

/// A place of a loop of borders.
struct LoopPlace {
    const LoopLine* line = nullptr;
    std::size_t chord = 0; ///< the place lies between this point of the line and the next
    Vec3 position{0};      ///< world, mm
};

/// Follows a loop from one of its places, one way or the other.
class LoopWalk {
public:
    /// A walk in the direction of the loop, or backwards.
    LoopWalk(const LoopPlace& from, bool forward);

    /// The first place `radius` mm from the beginning; nullopt if there is none. The radius may not
    /// fall from call to call.
    std::optional<Vec3> leave(double radius);

private:
    const LoopLine& line_;
    Vec3 from_, last_; ///< the beginning, and the point reached
    std::size_t next_; ///< the point beyond
    bool forward_;
    std::size_t passed_ = 0; ///< number of points
};

/// A border prepared for searching.
struct Border {
    SurfaceCurve curve;             ///< the exact curve, world, mm
    CurvePolyline polyline;         ///< chords near the curve, for the search
    const LoopLine* loop = nullptr; ///< the loop that it is part of
    std::size_t first = 0;          ///< the polyline's first point in the loop

    /// Makes the border the next of a loop, to which a reference is kept.
    void append_to(LoopLine& line);
    /// The place of the loop at parameter t of the border, which is at `position`.
    LoopPlace place(double t, const Vec3& position) const;
};

/// A place of a border and the direction of the border there.
struct BorderPlace {
    LoopPlace place;
    Vec3 along{0}; ///< of any length
};

/// Compares the runs of two borders at places that are at most `join` mm apart. They run alike if
/// they diverge by at most parallel_borders: in the places themselves, or over a length around them
/// of up to `join` over the sine of that angle. Borders that stay within `join` mm over that length
/// thus run alike, whatever teeth or waves they have. A border that turns back has no direction.
/// True if they have the same direction, false if opposite ones; nullopt if they do not run alike.
std::optional<bool> run_alike(const BorderPlace& a, const BorderPlace& b, double join);

} // namespace keiko
