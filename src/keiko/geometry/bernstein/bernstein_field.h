#pragma once

#include "keiko/math/bounds.h"
#include "keiko/math/interval.h"

#include <array>
#include <cstddef>
#include <vector>

namespace keiko {

/// A polynomial over [0, 1]^2 by its Bernstein coefficients, whose hull holds its values
/// [FaroukiRajan1988]. Degrees are not limited to those of patches. Keeps a bound of the rounding
/// error of each coefficient.
class BernsteinField {
public:
    BernsteinField() : BernsteinField(0, 0, {0.0}, 0) {}
    /// (degree_u + 1) x (degree_v + 1) coefficients, u outer.
    BernsteinField(int degree_u, int degree_v, std::vector<double> coefficients, double rounding)
        : degree_u_(degree_u),
          degree_v_(degree_v),
          coefficients_(std::move(coefficients)),
          rounding_(rounding) {}

    int degree_u() const { return degree_u_; }
    int degree_v() const { return degree_v_; }
    double rounding() const { return rounding_; }
    double at(int i, int j) const { return coefficients_[index(i, j)]; }

    /// The largest absolute coefficient.
    double magnitude() const;
    /// Range that holds every value.
    Interval range() const;
    /// Range of the side u = 0 or 1 (`by_u`), else v = 0 or 1.
    Interval side_range(bool by_u, bool upper) const;
    /// Derivative by u or v; 0 if the degree is 0.
    BernsteinField derivative(bool by_u) const;
    double operator()(const Vec2& uv) const;
    /// The parts below and above u (or v) = `share`, each over [0, 1]^2 again.
    std::array<BernsteinField, 2> parts(bool by_u, double share) const;
    /// The field divided by u (`by_u`, lower side), 1 - u (upper side), v or 1 - v, for a field
    /// that vanishes on that side; needs a degree of 1 or more.
    BernsteinField without_side(bool by_u, bool upper) const;

    friend BernsteinField operator*(const BernsteinField& a, const BernsteinField& b);
    /// Sum of two fields of equal degrees.
    friend BernsteinField operator+(const BernsteinField& a, const BernsteinField& b);
    friend BernsteinField operator-(const BernsteinField& a, const BernsteinField& b);

private:
    std::size_t index(int i, int j) const {
        return static_cast<std::size_t>(i) * static_cast<std::size_t>(degree_v_ + 1) +
               static_cast<std::size_t>(j);
    }

    int degree_u_, degree_v_;
    std::vector<double> coefficients_;
    double rounding_;
};

} // namespace keiko
