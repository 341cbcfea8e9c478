#pragma once

#include "keiko/math/rgb.h"
#include "keiko/radiosity/gather_rays.h"
#include "keiko/radiosity/radiosity_solution.h"
#include "keiko/radiosity/solved_triangle.h"

#include <cstddef>
#include <span>
#include <vector>

namespace keiko {

/// Light at a place of a triangle, lx, interpolated between its corners. `side`: 0 the front, 1 the
/// back.
inline Rgb interpolated(std::span<const BothSides> corners, const SolvedTriangle& triangle,
                        const Vec3& shares, std::size_t side) {
    const auto& [a, b, c] = triangle.corners;
    return corners[a][side] * shares.x + corners[b][side] * shares.y + corners[c][side] * shares.z;
}

/// Radiosity at places of elements. What comes from other elements varies smoothly between the
/// corners; what lamps bring directly has edges, and is the mean of an element.
class InterpolatedRadiosity {
public:
    /// `arriving`: lx at each corner. `exitance`, `reflectances`: of all fronts, then of all backs.
    /// Keeps references.
    InterpolatedRadiosity(std::span<const SolvedTriangle> triangles,
                          std::span<const BothSides> arriving, std::span<const Rgb> exitance,
                          std::span<const Rgb> reflectances)
        : triangles_(triangles),
          arriving_(arriving),
          exitance_(exitance),
          reflectances_(reflectances) {}

    /// Mean over rays of the radiosities that they meet, lm/m2: the illuminance in lx of the point
    /// that they start from.
    Rgb mean(std::span<const MetElement> met) const {
        Rgb sum;
        for (const MetElement& element : met)
            if (element.reflects()) sum += at(element);
        return sum / static_cast<double>(met.size());
    }

    /// Radiosity at a place, lm/m2.
    Rgb at(const MetElement& met) const {
        const std::size_t side = met.face < exitance_.size() / 2 ? 0 : 1;
        return at(met,
                  interpolated(arriving_, triangles_[met.place.triangle], met.place.shares, side));
    }
    /// Radiosity at a place where this light arrives from other elements.
    Rgb at(const MetElement& met, const Rgb& arriving) const {
        return exitance_[met.face] + reflectances_[met.face] * arriving;
    }

private:
    std::span<const SolvedTriangle> triangles_;
    std::span<const BothSides> arriving_;
    std::span<const Rgb> exitance_, reflectances_;
};

} // namespace keiko
