#pragma once

#include "keiko/light/fog/height_field.h"

#include <span>
#include <vector>

namespace keiko {

/// How far a segment lies over a height field, along z, as a function of its parameter: a straight
/// line less a sum of cosines, two a wave, whose second derivative is bounded.
class HeightAlong {
public:
    HeightAlong(const HeightField& field, const Segment& segment);

    struct Value {
        double height; ///< mm over the surface
        double slope;  ///< of that, per parameter
    };
    /// Not for two threads at once.
    Value at(double t) const;
    /// Of the second derivative per parameter.
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
