#pragma once

#include "keiko/math/interval_set.h"
#include "keiko/trace/segment_plane.h"
#include "keiko/trace/tangent_planes.h"

#include <algorithm>
#include <array>

namespace keiko {

/// The wedge between an apex and a part of a segment: only what reaches into it hides anything of
/// that part. Of parallel light it is a strip.
class SeenWedge {
public:
    SeenWedge(const SegmentPlane& plane, const ParameterInterval& part) {
        const Apex& apex = plane.apex();
        const std::array ends{plane.at(part.begin), plane.at(part.end)};
        for (unsigned k = 0; k < 2; ++k) {
            Vec3 inward = plane.normal().cross(apex.way_to(ends[k])).normalized();
            if (inward.dot(ends[1 - k] - ends[k]) < 0) inward = -inward;
            sides_[k] = {inward, apex.infinite() ? ends[k] : apex.place()};
        }
    }

    /// False when the convex hull of a net's points, relative to `center` and at most `reach` from
    /// it, is proved to lie outside.
    bool may_hold(const HomogeneousNet& net, const Vec3& center, double reach) const {
        return std::all_of(sides_.begin(), sides_.end(), [&](const Side& side) {
            const Vec3 &n = side.inward, way = center - side.place;
            const double margin = 1e-12 * (reach + way.length()); // far beyond rounding
            const Vec4 weights(n.x, n.y, n.z, n.dot(way) + margin);
            return std::any_of(net.points.begin(), net.points.end(),
                               [&](const Vec4& p) { return weights.dot(p) >= 0; });
        });
    }

private:
    struct Side {
        Vec3 inward{0}; ///< unit
        Vec3 place{0};  ///< on it
    };
    std::array<Side, 2> sides_;
};

} // namespace keiko
