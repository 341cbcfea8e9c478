#pragma once

#include "keiko/base/export.h"
#include "keiko/base/memory.h"
#include "keiko/math/bounds.h"
#include "keiko/math/ray_differentials.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace KEIKO_API keiko {

/// A place on a surface in which a hit was proved to lie: a box of patch parameters. Secondary rays
/// exclude the root they start from by it, not by an offset along the ray.
struct Root {
    std::uint32_t instance = 0, patch = 0; ///< of the placed patch
    Box2 uv;                               ///< of its parameters, which holds the root
};

/// A ray in world coordinates, mm. `direction` need not be unit; t counts in its lengths.
struct Ray {
    Vec3 origin{0}, direction{0, 0, 1}; ///< world, mm; `direction` of any length but 0
    double t_min = 0;                   ///< hits before it do not count
    double t_max = std::numeric_limits<double>::infinity(); ///< hits beyond it do not count
    std::optional<RayDifferentials> differentials{};        ///< of a camera ray, by the pixel
    /// Root excluded from the hits. It must be a root of this very ray, at t = 0 or at t_max: its
    /// start or its end.
    std::optional<Root> excluded{};

    /// Point at parameter t.
    Vec3 at(double t) const { return origin + direction * t; }
};

/// Array of rays, not initialised when resized.
using Rays = std::vector<Ray, DefaultInitAllocator<Ray>>;

/// Viewpoint of a visibility query: a point, or a direction towards parallel light, which is a
/// point at infinity. Homogeneous: (place, 1), or (unit direction towards the light, 0).
class Viewpoint {
public:
    /// Viewpoint at a point. On a surface, `excluded` is its own root, left out as for any
    /// secondary ray.
    static Viewpoint at(const Vec3& point, const std::optional<Root>& excluded = {}) {
        return {point, false, excluded};
    }
    /// Viewpoint at infinity, towards parallel light; the direction is of any length but 0.
    static Viewpoint towards(const Vec3& direction) { return {direction.normalized(), true, {}}; }

    /// True for a direction.
    bool infinite() const { return infinite_; }
    /// The point, or the unit direction towards it.
    const Vec3& place() const { return place_; }
    /// Root that rays from the viewpoint leave out.
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
