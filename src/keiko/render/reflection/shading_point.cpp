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
    // Normals compared as lines: neighbouring faces may be oriented differently.
    if (a.normal.cross(b.normal).length2() > squared_tangent * squared(a.normal.dot(b.normal)))
        return false;
    // A step away from the tangent planes of both: one surface in front of another.
    const Vec3 step = b.position - a.position;
    const double off = std::min(std::abs(step.dot(a.normal)), std::abs(step.dot(b.normal)));
    return !(squared(off) > squared(0.2) * step.length2());
}

SurfaceContinuity::SurfaceContinuity(int width, std::span<const SurfacePlace* const> places)
    : joins_(places.size()) {
    const auto w = static_cast<std::size_t>(width);
    const auto joined = [&](std::size_t a, std::size_t b) {
        return places[b] && is_same_surface(*places[a], *places[b]);
    };
    for (std::size_t row = 0; row < places.size(); row += w)
        for (std::size_t i = row; i < row + w; ++i) {
            if (!places[i]) continue;
            joins_[i] = {i + 1 < row + w && joined(i, i + 1),
                         i + w < places.size() && joined(i, i + w)};
        }
}

} // namespace keiko
