#pragma once

#include "keiko/math/interval_set.h"
#include "keiko/trace/segment_plane.h"

#include <algorithm>
#include <span>

namespace keiko {

/// The wedge between an apex that is a point and a part of a segment: only what reaches into it
/// hides anything of that part.
class SeenWedge {
public:
    SeenWedge(const SegmentPlane& plane, const ParameterInterval& part) {
        const Vec3 first = plane.apex().way_to(plane.at(part.begin)).normalized();
        const Vec3 last = plane.apex().way_to(plane.at(part.end)).normalized();
        inward_ = {plane.normal().cross(first), last.cross(plane.normal())};
        for (Vec3& side : inward_)
            if (side.dot(first + last) < 0) side = -side;
    }

    /// False when the convex hull of places, relative to the apex and with no component above
    /// `reach`, is proved to lie outside.
    bool may_hold(std::span<const Vec3> places, double reach) const {
        const double margin = 1e-9 * reach; // far beyond rounding
        return std::all_of(inward_.begin(), inward_.end(), [&](const Vec3& side) {
            return std::any_of(places.begin(), places.end(),
                               [&](const Vec3& x) { return side.dot(x) >= -margin; });
        });
    }

private:
    std::array<Vec3, 2> inward_; ///< unit, across the sides of the wedge
};

} // namespace keiko
