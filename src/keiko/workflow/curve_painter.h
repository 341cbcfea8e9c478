#pragma once

#include "keiko/film/film.h"
#include "keiko/math/vec.h"
#include "keiko/scene/camera.h"

#include <span>
#include <vector>

namespace keiko {

/// Draws curves on a body into a picture of it.
class CurvePainter {
public:
    /// Keeps references. `film`: the picture, with its depth. Throws std::out_of_range without it.
    CurvePainter(const Film& film, const Camera& camera);

    /// The curve through these points of the world, mm, in pixels, at most `step` pixels from place
    /// to place. Places that something hides are not a number.
    std::vector<Vec2> drawn(std::span<const Vec3> points, double step = 4) const;

private:
    int steps_between(const Vec3& a, const Vec3& b, double step) const;
    Vec2 pixel(const Vec3& place) const;
    bool seen(const Vec2& at, const Vec3& place) const;

    const Image& depth_;
    const Camera& camera_;
};

} // namespace keiko
