#pragma once

#include "keiko/geometry/visibility/visibility.h"

#include <vector>

namespace keiko {

/// A bump of a height field: amplitude sin(2 pi x / wavelength.x + phase.x) times the same of y.
struct Wave {
    double amplitude = 0;        ///< mm
    Vec2 wavelength{1000, 1000}; ///< mm, along x and y
    Vec2 phase{0, 0};            ///< degrees

    double height(double x, double y) const;
    /// Angles of the two sines, in turns.
    Vec2 turns(double x, double y) const;

    bool operator==(const Wave&) const = default;
};

/// The surface z = height + its waves, between the layers of a medium [NishitaShafts, section 5].
struct HeightField {
    double height = 0; ///< mm
    std::vector<Wave> waves{};

    /// z of the surface over a place, mm.
    double at(double x, double y) const;
    /// How far a point lies over the surface, along z; negative below.
    double above(const Vec3& point) const { return point.z - at(point.x, point.y); }

    bool operator==(const HeightField&) const = default;
};

/// Parameters of the segment, rising, at which it crosses the surface: all of them but for pairs
/// between which it is less than 1e-9 mm off.
std::vector<double> crossings(const HeightField& field, const Segment& segment);

/// A natural looking surface: waves of many lengths up to `wavelength` mm, of `amplitude` mm
/// altogether. The same for the same numbers.
std::vector<Wave> noise_waves(double amplitude, double wavelength);

} // namespace keiko
