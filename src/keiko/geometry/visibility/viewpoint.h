#pragma once

#include "keiko/geometry/bezier/ray.h"

#include <optional>

namespace keiko {

/// Viewpoint of a visibility query: a point, or a direction towards parallel light, which is a
/// point at infinity. Homogeneous: (place, 1), or (unit direction towards the light, 0).
class Viewpoint {
public:
    /// Viewpoint at a point. On a surface, `excluded` is its own root, left out as for any
    /// secondary ray.
    static Viewpoint at(const Vec3& point, const std::optional<Root>& excluded = {}) {
        return {point, false, excluded};
    }
    static Viewpoint towards(const Vec3& direction) { return {direction.normalized(), true, {}}; }

    bool infinite() const { return infinite_; }
    /// The point, or the unit direction towards it.
    const Vec3& place() const { return place_; }
    const std::optional<Root>& excluded() const { return excluded_; }
    /// Vector from the viewpoint to x; from infinity the unit direction of the light.
    Vec3 way_to(const Vec3& x) const { return infinite_ ? -place_ : x - place_; }
    /// Homogeneous coordinates relative to `center`.
    Vec4 seen_from(const Vec3& center) const {
        const Vec3 p = infinite_ ? place_ : place_ - center;
        return {p.x, p.y, p.z, infinite_ ? 0.0 : 1.0};
    }
    /// The ray that tests whether `x` is visible.
    Ray ray_to(const Vec3& x) const {
        Ray ray;
        ray.origin = infinite_ ? x : place_;
        ray.direction = infinite_ ? place_ : x - place_;
        if (!infinite_) ray.t_max = 1;
        ray.excluded = excluded_;
        return ray;
    }

private:
    Viewpoint(const Vec3& place, bool infinite, const std::optional<Root>& excluded)
        : place_(place), infinite_(infinite), excluded_(excluded) {}

    Vec3 place_;
    bool infinite_;
    std::optional<Root> excluded_;
};

} // namespace keiko
