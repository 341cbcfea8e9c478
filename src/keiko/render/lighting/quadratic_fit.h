#pragma once

#include "keiko/math/vec.h"

#include <array>
#include <cstddef>
#include <span>
#include <tuple>
#include <vector>

namespace keiko {

/// Place of a surface before a plane, which fitted light depends on.
struct ChartPlace {
    Vec2 at{0};        ///< position on the plane
    double height = 0; ///< over the plane, in the unit of `at`
    Vec2 tilt{0};      ///< component of the unit normal along the plane
};

/// Monomials of a place of position x, y, height h and tilt s, t: 1, x, y, x^2, x y, y^2, h, s, t,
/// s^2, s t, t^2.
using Monomials = std::array<double, 12>;

/// The monomials of a place.
inline Monomials monomials(const ChartPlace& place) {
    const Vec2 &p = place.at, &n = place.tilt;
    return {1,   p.x, p.y,       p.x * p.x, p.x * p.y, p.y * p.y, place.height,
            n.x, n.y, n.x * n.x, n.x * n.y, n.y * n.y};
}

/// Polynomial of a place by its monomials. Value: one of a vector space.
template <class Value>
class Quadratic {
public:
    /// Zero everywhere.
    explicit Quadratic(const Value& zero) { factors_.fill(zero); }

    /// Adds a value times the polynomial with these factors of the monomials.
    void add(const Value& value, const Monomials& factors) {
        for (std::size_t i = 0; i < factors.size(); ++i) factors_[i] += value * factors[i];
    }
    /// Value at the place of these monomials.
    Value at(const Monomials& powers) const {
        Value sum = factors_[0] * powers[0];
        for (std::size_t i = 1; i < powers.size(); ++i) sum += factors_[i] * powers[i];
        return sum;
    }

private:
    std::array<Value, std::tuple_size_v<Monomials>> factors_; ///< of the monomials
};

/// Fit of polynomials to values at nodes, by least squares: Gram and Schmidt's method
/// [GolubVanLoan2013, section 5.2].
class QuadraticFit {
public:
    /// Fit to values at `nodes`, one at least. Coordinates should be about -1 to 1. Terms that the
    /// nodes cannot tell from others are left out, such as all of the tilt for nodes on a plane.
    explicit QuadraticFit(std::span<const ChartPlace> nodes);

    /// The polynomial nearest to `values`, one a node.
    template <class Value>
    Quadratic<Value> to(std::span<const Value> values) const {
        Quadratic<Value> fit(values[0] * 0.0);
        for (const Term& term : basis_) {
            Value part = values[0] * term.at_nodes[0];
            for (std::size_t i = 1; i < values.size(); ++i) part += values[i] * term.at_nodes[i];
            fit.add(part, term.factors);
        }
        return fit;
    }
    /// Variance of the fitted value at the place of these monomials, in that of the values at the
    /// nodes: its leverage. At a node, the weight of its own value, 0 to 1; the error of what the
    /// other nodes alone predict there is that of the fit by 1 - leverage. More than 1 where the
    /// fit extrapolates.
    double leverage(const Monomials& powers) const;

private:
    /// A polynomial that is orthogonal to the others over the nodes, and of length 1.
    struct Term {
        Monomials factors{};
        std::vector<double> at_nodes{};
    };
    Term monomial(std::size_t number) const;

    std::vector<Monomials> nodes_;
    std::vector<Term> basis_;
};

} // namespace keiko
