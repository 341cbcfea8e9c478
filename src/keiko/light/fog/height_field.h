#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/rays/visibility.h"

#include <span>
#include <vector>

namespace KEIKO_API keiko {

/// A bump of a height field: amplitude sin(2 pi x / wavelength.x + phase.x) times the same of y.
struct Wave {
    double amplitude = 0;        ///< mm
    Vec2 wavelength{1000, 1000}; ///< mm, along x and y
    Vec2 phase{0, 0};            ///< degrees

    /// Height of this wave over a place, mm.
    double height(double x, double y) const;
    /// Angles of the two sines, in turns.
    Vec2 turns(double x, double y) const;

    bool operator==(const Wave&) const = default;
};

/// The surface z = height + its waves, between the layers of a medium [NishitaShafts, section 5].
struct HeightField {
    double height = 0;         ///< mm
    std::vector<Wave> waves{}; ///< added to the height

    /// z of the surface over a place, mm.
    double at(double x, double y) const;
    /// Height of a point over the surface, along z; negative below.
    double above(const Vec3& point) const { return point.z - at(point.x, point.y); }

    bool operator==(const HeightField&) const = default;
};

/// Parameters of the segment, rising, at which it crosses the surface. They are complete except for
/// pairs between which it deviates by less than 1e-9 mm from the surface.
std::vector<double> crossings(const HeightField& field, const Segment& segment);

/// A natural surface: waves of many lengths up to `wavelength` mm, of `amplitude` mm in total. The
/// same numbers give the same surface.
std::vector<Wave> noise_waves(double amplitude, double wavelength);

/// Height of a segment over a height field, along z, as a function of its parameter. It is a
/// straight line less a sum of cosines, two a wave, whose second derivative is bounded.
class HeightAlong {
public:
    /// Height of a segment over a field; keeps references.
    HeightAlong(const HeightField& field, const Segment& segment);

    /// Height and slope at a parameter.
    struct Value {
        double height; ///< mm over the surface
        double slope;  ///< of that, per parameter
    };
    /// Value at a parameter; not for two threads at once.
    Value at(double t) const;
    /// Bound of the second derivative per parameter.
    double bend() const { return bend_; }

private:
    /// Column k of the ripples -amplitude cos(2 pi (phase + turns t)).
    std::span<double> column(std::size_t k) const { return {&numbers_[k * count_], count_}; }
    std::span<double> amplitudes() const { return column(0); }
    std::span<double> phases() const { return column(1); }
    std::span<double> turns() const { return column(2); }

    double start_, rise_; ///< mm over the middle of the waves
    double bend_ = 0;
    std::size_t count_;
    mutable std::vector<double> numbers_; ///< three columns, and three of at()
};

} // namespace keiko
