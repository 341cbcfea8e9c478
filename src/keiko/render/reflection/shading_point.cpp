#include "keiko/render/reflection/shading_point.h"

#include "keiko/base/units.h"

#include <algorithm>
#include <cmath>

namespace keiko {

namespace {

double squared(double x) {
    return x * x;
}

const double squared_tangent = squared(std::tan(degrees_to_radians(10)));

} // namespace

bool is_same_surface(const SurfacePlace& a, const SurfacePlace& b) {
    if (a.paint != b.paint) return false;
    // Normals as lines: neighbouring faces may be oriented differently.
    if (a.normal.cross(b.normal).length2() > squared_tangent * squared(a.normal.dot(b.normal)))
        return false;
    // A step off the tangent planes of both: one surface in front of another.
    const Vec3 step = b.position - a.position;
    const double off = std::min(std::abs(step.dot(a.normal)), std::abs(step.dot(b.normal)));
    return !(squared(off) > squared(0.2) * step.length2());
}

} // namespace keiko
