#include "keiko/placement/oriented_box.h"

namespace keiko {
namespace {

double reach(const OrientedBox& box, const Vec3& direction) {
    return std::abs(box.axes[0].dot(direction)) * box.half.x +
           std::abs(box.axes[1].dot(direction)) * box.half.y +
           std::abs(box.axes[2].dot(direction)) * box.half.z;
}

bool separates(const Vec3& axis, const OrientedBox& a, const OrientedBox& b) {
    return std::abs((b.center - a.center).dot(axis)) > reach(a, axis) + reach(b, axis);
}

} // namespace

OrientedBox oriented(const Box3& box) {
    return {.center = box.center(), .half = box.extent() / 2};
}

OrientedBox oriented(const CPlane& plane) {
    const Vec3 u = plane.u.normalized(), v = plane.v.normalized();
    return {.center = plane.origin + (plane.u + plane.v) / 2,
            .axes = {u, v, u.cross(v)},
            .half = {plane.u.length() / 2, plane.v.length() / 2, plane.diameter / 2}};
}

bool overlap(const OrientedBox& a, const OrientedBox& b) {
    for (const Vec3& axis : a.axes)
        if (separates(axis, a, b)) return false;
    for (const Vec3& axis : b.axes)
        if (separates(axis, a, b)) return false;
    for (const Vec3& one : a.axes)
        for (const Vec3& other : b.axes) // of parallel edges the product is 0 and separates nothing
            if (separates(one.cross(other), a, b)) return false;
    return true;
}

} // namespace keiko
