#pragma once

#include "keiko/visibility/nets/tangent_planes.h"

#include <array>

namespace keiko {

/// A place and axes that the points of a net are relative to.
struct NetFrame {
    Vec3 center{0};                                                        ///< world, mm
    std::array<Vec3, 3> rows{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}; ///< unit, world

    /// A direction in the axes.
    Vec3 local(const Vec3& v) const { return {rows[0].dot(v), rows[1].dot(v), rows[2].dot(v)}; }
    /// What weighs homogeneous coordinates of the frame as `w` does those in world axes that are
    /// relative to `center`; the same turns points and tangent planes.
    Vec4 local(const Vec4& w) const {
        const Vec3 v = local(Vec3(w.x, w.y, w.z));
        return {v.x, v.y, v.z, w.w};
    }
};

/// Into the axes of a frame, from world axes.
inline HomogeneousNet turned(HomogeneousNet net, const NetFrame& frame) {
    for (Vec4& p : net.points) p = frame.local(p);
    return net;
}

} // namespace keiko
