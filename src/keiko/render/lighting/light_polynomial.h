#pragma once

#include "keiko/math/vec.h"
#include "keiko/render/reflection/shading_point.h"

#include <array>

namespace keiko {

/// Light over a grid of places, of degree two at most in either of their coordinates.
class LightPolynomial {
public:
    using Powers = std::array<double, 3>; ///< of 1, x and its square

    /// Adds a light times a polynomial of x and one of y.
    void add(const DirectLight& light, const Powers& of_x, const Powers& of_y) {
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t i = 0; i < 3; ++i) factors_[j][i] += light * (of_x[i] * of_y[j]);
    }
    LightPolynomial& operator+=(const LightPolynomial& o) {
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t i = 0; i < 3; ++i) factors_[j][i] += o.factors_[j][i];
        return *this;
    }

    DirectLight at(const Vec2& place) const {
        const auto along = [&](const std::array<DirectLight, 3>& row) {
            return (row[2] * place.x + row[1]) * place.x + row[0];
        };
        return (along(factors_[2]) * place.y + along(factors_[1])) * place.y + along(factors_[0]);
    }

private:
    std::array<std::array<DirectLight, 3>, 3> factors_{}; ///< by the power of y, then of x
};

} // namespace keiko
