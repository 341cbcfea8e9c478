#pragma once

#include "keiko/math/vec.h"

#include <array>
#include <cmath>

namespace keiko {

/// A function over [-1, 1]^2 as a polynomial of total degree 3 and how far it may deviate from that
/// anywhere, rounding included: a Taylor model [MakinoBerz2003]. Unlike in intervals, what cancels
/// stays cancelled.
struct TaylorModel {
    static constexpr std::size_t count = 10; ///< coefficients of a polynomial
    /// Coefficients of 1; x, y; xx, xy, yy; xxx, xxy, xyy, yyy.
    std::array<double, count> c{};
    double error = 0; ///< bound of the function's deviation from the polynomial

    TaylorModel() = default;
    /// Model of a constant, without error.
    TaylorModel(double constant) { c[0] = constant; }

    /// Bound of the terms of degree 1.
    double linear_part() const { return std::abs(c[1]) + std::abs(c[2]); }
    /// Bound of the terms of degree 2.
    double square_part() const { return std::abs(c[3]) + std::abs(c[4]) + std::abs(c[5]); }
    /// Bound of the terms of degree 3.
    double cubic_part() const {
        return std::abs(c[6]) + std::abs(c[7]) + std::abs(c[8]) + std::abs(c[9]);
    }
    /// Bound of the function's difference from its constant.
    double deviation() const { return linear_part() + square_part() + cubic_part() + error; }
    /// Bound of the terms that change along x.
    double along_x() const {
        return std::abs(c[1]) + std::abs(c[3]) + std::abs(c[4]) + cubic_part() - std::abs(c[9]);
    }
    /// Bound of the terms that change along y.
    double along_y() const {
        return std::abs(c[2]) + std::abs(c[4]) + std::abs(c[5]) + cubic_part() - std::abs(c[6]);
    }
};

namespace taylor_rounding {
/// Relative rounding of a coefficient that sums up to ten products, and of the sums of absolute
/// values around it.
constexpr double product = 8e-15;
/// Relative rounding of a sum of two, and of a product with a number.
constexpr double sum = 4e-16;
} // namespace taylor_rounding

/// Model of the sum of two functions.
inline TaylorModel operator+(const TaylorModel& a, const TaylorModel& b) {
    TaylorModel sum;
    for (std::size_t i = 0; i < TaylorModel::count; ++i) sum.c[i] = a.c[i] + b.c[i];
    sum.error = a.error + b.error +
                taylor_rounding::sum * (std::abs(sum.c[0]) + sum.deviation() + a.error + b.error);
    return sum;
}
/// Model of the negative function, with the same error.
inline TaylorModel operator-(const TaylorModel& a) {
    TaylorModel negative(a);
    for (double& coefficient : negative.c) coefficient = -coefficient;
    return negative;
}
/// Model of the difference of two functions.
inline TaylorModel operator-(const TaylorModel& a, const TaylorModel& b) {
    return a + -b;
}
/// Model of a function times a number.
inline TaylorModel operator*(const TaylorModel& a, double factor) {
    TaylorModel product(a);
    for (double& coefficient : product.c) coefficient *= factor;
    product.error =
        (a.error + taylor_rounding::sum * (std::abs(a.c[0]) + a.deviation())) * std::abs(factor);
    return product;
}
/// Model of the product of two functions. Terms above degree 3 go to its error.
inline TaylorModel operator*(const TaylorModel& a, const TaylorModel& b) {
    const auto &p = a.c, &q = b.c;
    TaylorModel r;
    r.c = {p[0] * q[0],
           p[0] * q[1] + p[1] * q[0],
           p[0] * q[2] + p[2] * q[0],
           p[0] * q[3] + p[1] * q[1] + p[3] * q[0],
           p[0] * q[4] + p[1] * q[2] + p[2] * q[1] + p[4] * q[0],
           p[0] * q[5] + p[2] * q[2] + p[5] * q[0],
           p[0] * q[6] + p[1] * q[3] + p[3] * q[1] + p[6] * q[0],
           p[0] * q[7] + p[1] * q[4] + p[2] * q[3] + p[3] * q[2] + p[4] * q[1] + p[7] * q[0],
           p[0] * q[8] + p[1] * q[5] + p[2] * q[4] + p[4] * q[2] + p[5] * q[1] + p[8] * q[0],
           p[0] * q[9] + p[2] * q[5] + p[5] * q[2] + p[9] * q[0]};
    const double a1 = a.linear_part(), a2 = a.square_part(), a3 = a.cubic_part();
    const double b1 = b.linear_part(), b2 = b.square_part(), b3 = b.cubic_part();
    const double all_a = std::abs(p[0]) + a1 + a2 + a3, all_b = std::abs(q[0]) + b1 + b2 + b3;
    const double beyond = a1 * b3 + a2 * (b2 + b3) + a3 * (b1 + b2 + b3);
    r.error = beyond + all_a * b.error + a.error * (all_b + b.error) +
              taylor_rounding::product * (all_a + a.error) * (all_b + b.error);
    return r;
}
/// Model of a function times itself, as of any product.
inline TaylorModel square(const TaylorModel& a) {
    return a * a;
}

/// Upper bound of a function over [-1, 1]^2, and where that is likely.
struct TaylorPeak {
    double bound = 0; ///< the function is nowhere larger
    Vec2 place{0};    ///< where its quadratic part is largest
};

/// The largest value of the quadratic part, which is exact, with the rest added. Infinite for an
/// unknown model.
TaylorPeak peak(const TaylorModel& model);

/// False only if the function is nowhere 0.
bool may_vanish(const TaylorModel& model);

/// Model of the function along the line where x is `at`: a function of y alone.
TaylorModel at_x(const TaylorModel& model, double at);
/// Model of the function along the line where y is `at`: a function of x alone.
TaylorModel at_y(const TaylorModel& model, double at);

/// The reciprocal of a model; its error is infinite where the model may be 0.
TaylorModel reciprocal(const TaylorModel& model);

/// Model of the quotient of two functions; its error is infinite where b may be 0.
inline TaylorModel operator/(const TaylorModel& a, const TaylorModel& b) {
    return a * reciprocal(b);
}

/// The square root of a model; its error is infinite where the model may be 0 or less.
TaylorModel sqrt(const TaylorModel& model);

/// The model to the power -3/2; its error is infinite where the model may be 0 or less.
TaylorModel inverse_cubed_root(const TaylorModel& model);

} // namespace keiko
