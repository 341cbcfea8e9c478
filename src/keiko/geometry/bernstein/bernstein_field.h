#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/bernstein/bernstein.h"
#include "keiko/math/bounds.h"
#include "keiko/math/interval.h"

#include <array>
#include <cstddef>
#include <vector>

namespace KEIKO_API keiko {

class BernsteinField;
/// Product; the degrees add up.
BernsteinField operator*(const BernsteinField& a, const BernsteinField& b);
/// Sum of two fields of equal degrees.
BernsteinField operator+(const BernsteinField& a, const BernsteinField& b);
/// Difference of two fields of equal degrees.
BernsteinField operator-(const BernsteinField& a, const BernsteinField& b);

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

    /// Degree in u.
    int degree_u() const { return degree_u_; }
    /// Degree in v.
    int degree_v() const { return degree_v_; }
    /// Bound of the rounding error of each coefficient.
    double rounding() const { return rounding_; }
    /// Coefficient i in u, j in v.
    double at(int i, int j) const { return coefficients_[index(i, j)]; }

    /// The largest absolute coefficient.
    double magnitude() const;
    /// Range that holds every value.
    Interval range() const;
    /// Range of the side u = 0 or 1 (`by_u`), else v = 0 or 1.
    Interval side_range(bool by_u, bool upper) const;
    /// Derivative by u or v; 0 if the degree is 0.
    BernsteinField derivative(bool by_u) const;
    /// Value at a place of [0, 1]^2.
    double operator()(const Vec2& uv) const;
    /// The parts below and above u (or v) = `share`, each over [0, 1]^2 again.
    std::array<BernsteinField, 2> parts(bool by_u, double share) const;
    /// The field divided by u (`by_u`, lower side), 1 - u (upper side), v or 1 - v, for a field
    /// that vanishes on that side; needs a degree of 1 or more.
    BernsteinField without_side(bool by_u, bool upper) const;

    /// Declared above.
    friend BernsteinField operator*(const BernsteinField& a, const BernsteinField& b);
    /// Declared above.
    friend BernsteinField operator+(const BernsteinField& a, const BernsteinField& b);
    /// Declared above.
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

/// Bernstein coefficients, u outer, of a function of (x, y) over [-1, 1]^2.
struct BernsteinNet {
    /// Number of coefficients that there is room for.
    static constexpr std::size_t capacity = std::size_t{max_degree + 1} * (max_degree + 1);

    std::size_t rows, columns;      ///< one more than the degrees
    std::array<double, capacity> c; ///< beyond rows * columns undefined

    /// Coefficient of row i and column j.
    double& at(std::size_t i, std::size_t j) { return c[i * columns + j]; }
    /// Coefficient of row i and column j.
    double at(std::size_t i, std::size_t j) const { return c[i * columns + j]; }
};

/// Bounds over [-1, 1]^2 of a function f and its derivatives by x and y.
struct NetBounds {
    double low = 0, high = 0;                 ///< of f
    double slope = 0;                         ///< of |f_x| + |f_y|
    double bend = 0;                          ///< of |f_xx| + 2 |f_xy| + |f_yy|
    double bend_u = 0, bend_v = 0, twist = 0; ///< of |f_xx|, |f_yy|, |f_xy|
};

/// Bounds by the convex hulls of the four quadrants' coefficients. For a parabola over the whole
/// these are exact, while the hull of the whole is twice too wide. Rounding is included.
NetBounds net_bounds(const BernsteinNet& net);

} // namespace keiko
