#pragma once

#include "keiko/geometry/rays/ray.h"
#include "keiko/math/bounds.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace keiko {

/// The space between a light without extent and a line or a triangle that it may light: what casts
/// shadows onto them lies there.
class LightPyramid {
public:
    /// `receiver`: two or three corners, world, mm. `rounding`: mm by which what lies on the
    /// receiver may be off it.
    LightPyramid(std::span<const Vec3> receiver, const Viewpoint& light, double rounding);

    /// False if the light runs within the receiver, on which it casts no shadow then.
    bool lights() const { return lights_; }
    /// False if a box is proved to lie outside.
    bool meets(const Box3& box) const;
    /// The shadow of a triangle on the receiver: a convex polygon by the shares of the receiver's
    /// corners, which sum to 1; of a line both ends of its shadow are among the corners. Empty if
    /// none falls there.
    std::vector<Vec3> shadow_of(const std::array<Vec3, 3>& triangle) const;

private:
    /// Not negative within.
    struct Plane {
        Vec3 normal{0};
        double offset = 0;

        double at(const Vec3& point) const { return normal.dot(point) + offset; }
        bool misses(const Box3& box) const;
    };

    void add_line(std::span<const Vec3> receiver, const Viewpoint& light, double rounding);
    void add_triangle(std::span<const Vec3> receiver, const Viewpoint& light, double rounding);
    /// The plane of unit normal through `point`, moved outwards.
    void add(const Vec3& normal, const Vec3& point, double outwards);
    /// The side that holds the light and all corners but one, 1 at that corner.
    void add_side(const Vec3& normal, const Vec3& on, const Vec3& corner);

    bool lights_ = true;
    std::vector<Plane> bounds_; ///< beside the sides
    std::vector<Plane> sides_;  ///< opposite to the corners, in their order
};

} // namespace keiko
