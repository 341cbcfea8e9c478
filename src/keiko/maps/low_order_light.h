#pragma once

#include "keiko/math/rgb.h"
#include "keiko/math/vec.h"

#include <array>

namespace keiko {

/// Spherical harmonics up to the second order of light from all sides, as the polynomial
/// a + b w + w C w of the direction w, C without trace [RamamoorthiHanrahan2001].
class LowOrderLight {
public:
    /// Adds light of a luminance from a solid angle, sr, about a unit direction.
    void add(const Vec3& direction, const Rgb& luminance, double solid_angle);

    /// lx on a surface with a unit normal, from all of the hemisphere before it; 0 where the low
    /// orders alone would make it negative.
    Rgb irradiance(const Vec3& normal) const;

private:
    Rgb mean_;
    std::array<Rgb, 3> slope_{};
    std::array<Rgb, 6> bend_{}; ///< xx, yy, zz, xy, xz, yz
};

} // namespace keiko
