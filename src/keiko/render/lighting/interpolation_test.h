#pragma once

#include "keiko/math/vec.h"
#include "keiko/render/lighting/error_budget.h"
#include "keiko/render/lighting/light_samples.h"
#include "keiko/render/lighting/shading_grid.h"
#include "keiko/render/reflection/shading_point.h"

#include <array>
#include <cmath>

namespace keiko {

// Light interpolated over a rectangle of a grid, and the test whether it is near enough.

/// Light over a grid of places, of degree two at most in either of their coordinates.
class LightPolynomial {
public:
    using Powers = std::array<double, 3>; ///< of 1, x and its square

    /// Adds a light times a polynomial of x and one of y.
    void add(const DirectLight& light, const Powers& of_x, const Powers& of_y) {
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t i = 0; i < 3; ++i) factors_[j][i] += light * (of_x[i] * of_y[j]);
    }
    /// Adds another polynomial.
    LightPolynomial& operator+=(const LightPolynomial& o) {
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t i = 0; i < 3; ++i) factors_[j][i] += o.factors_[j][i];
        return *this;
    }

    /// Light at a position of the grid, as ShadingGrid::place() returns it.
    DirectLight at(const Vec2& place) const {
        const auto along = [&](const std::array<DirectLight, 3>& row) {
            return (row[2] * place.x + row[1]) * place.x + row[0];
        };
        return (along(factors_[2]) * place.y + along(factors_[1])) * place.y + along(factors_[0]);
    }

private:
    std::array<std::array<DirectLight, 3>, 3> factors_{}; ///< by the power of y, then of x
};

/// Polynomials that interpolate the light on a rectangle of a grid from that at some of its places.
class Interpolant {
public:
    /// Linear in either coordinate, through the corners.
    static Interpolant lines(const ShadingGrid& grid, const Rectangle& r);
    /// Polynomial of degree two in either coordinate, through the corners and middles; where a
    /// middle lies near a corner, linear.
    static Interpolant parabolas(const ShadingGrid& grid, const Rectangle& r);

    /// True if it interpolates the middles too.
    bool goes_through_middles() const { return columns_.size() != 2 && rows_.size() != 2; }

    /// Weights of the light at each node for a place of the grid.
    using Weights = std::array<double, 9>;
    /// Weights for a position of the grid, which sum up to 1; 0 beyond the last node.
    Weights weights(const Vec2& place) const;
    /// Sum of `light(node)` over all nodes with these weights.
    template <class Light>
    DirectLight sum(const Weights& weights, const Light& light) const {
        DirectLight sum;
        for (std::size_t i = 0; i < size(); ++i) sum += light(node(i)) * weights[i];
        return sum;
    }
    /// The polynomial through `light(node)` of all nodes.
    template <class Light>
    LightPolynomial through(const Light& light) const {
        LightPolynomial polynomial;
        for (std::size_t i = 0; i < size(); ++i)
            polynomial.add(light(node(i)), columns_.powers(i % columns_.size()),
                           rows_.powers(i / columns_.size()));
        return polynomial;
    }

private:
    /// Places along one coordinate, each with the polynomial that is 1 there and 0 at the others
    /// (Lagrange).
    class Nodes {
    public:
        /// Nodes at both ends; one if they are the same.
        Nodes(int first, double begin, int last, double end);
        void add(int middle, double place);

        std::size_t size() const { return size_; }
        int number(std::size_t i) const { return numbers_[i]; }
        LightPolynomial::Powers powers(std::size_t i) const;
        double weight(std::size_t i, double place) const;

    private:
        std::size_t size_;
        std::array<int, 3> numbers_;
        std::array<double, 3> places_;
    };
    Interpolant(const Nodes& columns, const Nodes& rows) : columns_(columns), rows_(rows) {}

    std::size_t size() const { return columns_.size() * rows_.size(); }
    Pixel node(std::size_t i) const {
        return {columns_.number(i % columns_.size()), rows_.number(i / columns_.size())};
    }

    Nodes columns_, rows_;
};

inline Interpolant::Nodes::Nodes(int first, double begin, int last, double end)
    : size_(begin < end ? 2 : 1), numbers_{first, last, 0}, places_{begin, end, 0} {}

inline void Interpolant::Nodes::add(int middle, double place) {
    constexpr double least_share = 0.2; // of the distance to either end
    const double way = places_[1] - places_[0];
    if (size_ < 2 || std::min(place - places_[0], places_[1] - place) < least_share * way) return;
    numbers_[2] = middle;
    places_[2] = place;
    size_ = 3;
}

inline double Interpolant::Nodes::weight(std::size_t i, double place) const {
    double weight = 1;
    for (std::size_t k = 0; k < size_; ++k)
        if (k != i) weight *= (place - places_[k]) / (places_[i] - places_[k]);
    return weight;
}

inline LightPolynomial::Powers Interpolant::Nodes::powers(std::size_t i) const {
    LightPolynomial::Powers powers{1, 0, 0};
    for (std::size_t k = 0; k < size_; ++k) {
        if (k == i) continue;
        const double scale = 1 / (places_[i] - places_[k]), at = places_[k];
        powers = {-at * powers[0] * scale, (powers[0] - at * powers[1]) * scale,
                  (powers[1] - at * powers[2]) * scale};
    }
    return powers;
}

inline Interpolant Interpolant::lines(const ShadingGrid& grid, const Rectangle& r) {
    const Vec2 begin = grid.place({r.x0, r.y0}), end = grid.place({r.x1, r.y1});
    return {Nodes(r.x0, begin.x, r.x1, end.x), Nodes(r.y0, begin.y, r.y1, end.y)};
}

inline Interpolant Interpolant::parabolas(const ShadingGrid& grid, const Rectangle& r) {
    Interpolant fit = lines(grid, r);
    const Vec2 middle = grid.place(r.middle());
    fit.columns_.add(r.middle().x, middle.x);
    fit.rows_.add(r.middle().y, middle.y);
    return fit;
}

inline Interpolant::Weights Interpolant::weights(const Vec2& place) const {
    Weights weights{};
    for (std::size_t i = 0; i < size(); ++i)
        weights[i] = columns_.weight(i % columns_.size(), place.x) *
                     rows_.weight(i / columns_.size(), place.y);
    return weights;
}

/// Test whether lights are interpolated over rectangles of a grid from those at a few of their
/// places.
class InterpolationTest {
public:
    /// Test with the visible luminance `seen` of each place besides; the error allowed for all
    /// lights together is `error` of the visible luminance. Keeps references to all; computes into
    /// `lights`.
    InterpolationTest(const Integrator& integrator, const ShadingGrid& grid,
                      std::span<const Rgb> seen, double error, LightSamples& lights)
        : integrator_(integrator), grid_(grid), seen_(seen), error_(error), lights_(lights) {}

    /// Interpolated lights, by rising number.
    struct Accepted {
        Lights parabolas; ///< of degree two: Interpolant::parabolas of the rectangle
        Lights lines;     ///< linear, which in each quarter is Interpolant::lines
        Lights seen;      ///< with a visibility that is linear in each quarter
        /// Subset of all these for which that only holds in quarters without a shadow: they are
        /// visible from all tested places, but something may come between. Empty for small squares:
        /// shadows narrower than two pixels are not searched for there.
        Lights threatened;

        /// All interpolated lights.
        Lights all() const { return united(seen, united(lines, parabolas)); }
    };
    /// Accepted subset of the lights that are open over a rectangle; `known` is the light of the
    /// others there. The accepted lights reduce `left`, the remaining allowed error.
    Accepted tell(const Rectangle& r, const LightPolynomial& known, const UnresolvedLights& open,
                  double& left);

private:
    /// A place by which lights are judged.
    struct Test {
        Pixel place;
        ErrorBudget allowed;
    };
    Test test_at(const Pixel& p, const DirectLight& total) const;
    /// Sum of some lights at places.
    auto sum_of(std::span<const std::size_t> lights) const {
        return [this, lights](const Pixel& p) { return lights_.sum(p.x, p.y, lights); };
    }

    Lights threatened(const Rectangle& r, const Lights& lights) const;
    std::vector<Test> middles_of(const Rectangle& r, const LightPolynomial& known,
                                 const UnresolvedLights& open);
    std::vector<Test> odd_places_of(const Rectangle& r, const LightPolynomial& known,
                                    const UnresolvedLights& open, const Lights& hopeful);
    std::vector<LightError> doubts_in_parabolas(const Rectangle& r,
                                                const std::vector<Test>& middles,
                                                const std::vector<Test>& odd, const Lights& lights,
                                                double left) const;
    bool sees_alike(const Rectangle& r, const std::vector<Test>& odd, std::size_t light) const;
    void test(const Interpolant& fit, const std::vector<Test>& tests, double most,
              std::vector<LightError>& errors) const;
    void test_seen(const Rectangle& r, const std::vector<Test>& tests, double most,
                   std::vector<LightError>& errors) const;
    std::optional<DirectLight> wrong_if_seen_linearly(const LinearlySeen& linear,
                                                      const Pixel& p) const;

    const Integrator& integrator_;
    const ShadingGrid& grid_;
    std::span<const Rgb> seen_;
    double error_;
    LightSamples& lights_;
};

} // namespace keiko
