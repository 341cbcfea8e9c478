#include "keiko/maps/projection.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

ProjectedPlace on_plane(const MapProjection& p, const Vec3& q) {
    const Vec3 u = p.u / p.u.length2();
    const Vec3 across = square_to(p.v, p.u), v = across / across.length2();
    return {{q.dot(u), q.dot(v)}, u, v};
}

/// A place about an axis: its coordinates across it, and along it.
struct AxialPlace {
    Vec3 axis, e0, e1;
    double x, y, z;

    AxialPlace(const MapProjection& p, const Vec3& q)
        : axis(p.axis.normalized()),
          e0(square_to(p.u, axis).normalized()),
          e1(axis.cross(e0)),
          x(q.dot(e0)),
          y(q.dot(e1)),
          z(q.dot(axis)) {}

    double radius2() const { return x * x + y * y; }
    double turns() const { return wrapped(std::atan2(y, x) / (2 * std::numbers::pi)); }
    Vec3 grad_turns() const {
        return radius2() > 0 ? (e1 * x - e0 * y) / (2 * std::numbers::pi * radius2()) : Vec3(0);
    }
};

ProjectedPlace on_cylinder(const MapProjection& p, const Vec3& q) {
    const AxialPlace at(p, q);
    return {{at.turns(), at.z / p.height}, at.grad_turns(), at.axis / p.height};
}

ProjectedPlace on_sphere(const MapProjection& p, const Vec3& q) {
    const AxialPlace at(p, q);
    const double radius = std::sqrt(at.radius2()), length2 = q.length2();
    const double v = std::atan2(radius, at.z) / std::numbers::pi;
    if (!(radius > 0)) return {{at.turns(), v}, Vec3(0), Vec3(0)};
    const Vec3 outwards = (at.e0 * at.x + at.e1 * at.y) / radius;
    const Vec3 grad_v = (outwards * at.z - at.axis * radius) / (length2 * std::numbers::pi);
    return {{at.turns(), v}, at.grad_turns(), grad_v};
}

} // namespace

double wrapped(double coordinate) {
    const double rest = coordinate - std::floor(coordinate);
    return rest < 1 ? rest : 0; // of a tiny negative number
}

ProjectedPlace projected(const MapProjection& projection, const Vec3& place) {
    const Vec3 q = place - projection.origin;
    switch (projection.kind) {
        case ProjectionKind::planar:
            return on_plane(projection, q);
        case ProjectionKind::cylindrical:
            return on_cylinder(projection, q);
        case ProjectionKind::spherical:
            return on_sphere(projection, q);
        case ProjectionKind::solid:
        case ProjectionKind::parameter:
            break;
    }
    assert(!"solid textures and parameters are not projected");
    return {};
}

} // namespace keiko
