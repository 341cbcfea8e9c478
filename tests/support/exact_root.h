#pragma once

#include "keiko/geometry/rays/ray.h"

#include "tests/support/exact_patch.h"

#include <optional>

namespace keiko::test {

/// An intersection of a ray, exactly as its doubles describe it, with a patch.
struct ExactRoot {
    Long u, v;         ///< patch parameters, perhaps outside [0, 1]
    LongVec3 position; ///< mm
    Long t;
    Long sine;  ///< of the angle between the ray and the surface, signed by the side of du x dv
    Long error; ///< mm, bound of the distance from `position` to the exact intersection

    bool on_patch() const { return u >= 0 && u <= 1 && v >= 0 && v <= 1; }
};

/// The root that Newton's method finds from `start` in long double. Nothing when it does not
/// settle, or when the surface is so nearly tangential there that even in long double rounding
/// might have made the root: none of those proves that a hit is lost.
std::optional<ExactRoot> exact_root(const ExactPatch& patch, const Ray& ray, const Vec2& start);

/// Distance from a point to the ray's line, mm.
Long off_line(const Ray& ray, const LongVec3& point);

} // namespace keiko::test
