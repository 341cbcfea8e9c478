#pragma once

#include "keiko/math/interval_set.h"
#include "keiko/visibility/boundaries/segment_plane.h"

#include <array>

namespace keiko {

/// The wedge between a viewpoint and a part of a segment: only what reaches into it hides anything
/// of that part. Of parallel light it is a strip.
class ShadowWedge {
public:
    ShadowWedge(const SegmentPlane& plane, const ParameterInterval& part) {
        const Viewpoint& viewpoint = plane.viewpoint();
        const std::array ends{plane.at(part.begin), plane.at(part.end)};
        for (unsigned k = 0; k < 2; ++k) {
            Vec3 inward = plane.normal().cross(viewpoint.way_to(ends[k])).normalized();
            if (inward.dot(ends[1 - k] - ends[k]) < 0) inward = -inward;
            sides_[k] = {inward, viewpoint.infinite() ? ends[k] : viewpoint.place()};
        }
    }

    /// What weighs homogeneous coordinates relative to `center`, of points at most `reach` from it,
    /// into how far they lie inside of each side, mm.
    std::array<Vec4, 2> weights(const Vec3& center, double reach) const {
        std::array<Vec4, 2> of_sides{Vec4(0), Vec4(0)};
        for (unsigned k = 0; k < 2; ++k) {
            const Vec3 &n = sides_[k].inward, way = center - sides_[k].place;
            const double margin = 1e-12 * (reach + way.length()); // far beyond rounding
            of_sides[k] = Vec4(n.x, n.y, n.z, n.dot(way) + margin);
        }
        return of_sides;
    }

private:
    struct Side {
        Vec3 inward{0}; ///< unit
        Vec3 place{0};  ///< on it
    };
    std::array<Side, 2> sides_;
};

} // namespace keiko
