#pragma once

#include "keiko/inspect/inspection.h"

#include "tests/support/model_builder.h"
#include "tests/unit/inspect/bernstein.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

namespace keiko::test {

constexpr std::size_t profile_order = 9; ///< of every polynomial: degree 8
using Polynomial = std::array<double, profile_order>;

/// A function of one coordinate by polynomials between knots, each about the middle of its piece.
struct Profile {
    std::vector<double> knots; ///< mm
    std::vector<Polynomial> pieces;

    /// Bernstein coefficients of all pieces in a row, shared where they meet.
    std::vector<double> coefficients() const {
        std::vector<double> row;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const double extent = knots[i + 1] - knots[i];
            const Polynomial b = bernstein<profile_order>(pieces[i], -extent / 2, extent);
            if (!row.empty()) row.pop_back();
            row.insert(row.end(), b.begin(), b.end());
        }
        return row;
    }
    std::vector<double> knot_vector() const {
        std::vector<double> all(1, knots.front());
        for (const double knot : knots) all.insert(all.end(), profile_order - 1, knot);
        all.push_back(knots.back());
        return all;
    }
};

constexpr double half_sheet =
    150; ///< mm: sheets run from minus to plus that where not said otherwise

/// a + b x + c x^2 / 2 about the middle of each piece between the knots.
inline Profile parabola(const std::vector<double>& knots, double bend) {
    Profile p{knots, {}};
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
        const double m = (knots[i] + knots[i + 1]) / 2;
        p.pieces.push_back({bend * m * m / 2, bend * m, bend / 2});
    }
    return p;
}

/// a(x) about the middle of a piece, about another place of it.
inline Polynomial shifted(const Polynomial& a, double by) {
    Polynomial b{};
    for (std::size_t k = 0; k < profile_order; ++k) {
        double power = 1, choose = 1; // of (x + by)^k
        for (std::size_t j = k + 1; j-- > 0;) {
            b[j] += a[k] * choose * power;
            power *= by, choose *= static_cast<double>(j) / static_cast<double>(k - j + 1);
        }
    }
    return b;
}

/// Part of a profile between two places.
inline Profile part(const Profile& whole, double begin, double end) {
    Profile p{{begin}, {}};
    for (std::size_t i = 0; i < whole.pieces.size(); ++i) {
        const double from = std::max(begin, whole.knots[i]), to = std::min(end, whole.knots[i + 1]);
        if (!(from < to)) continue;
        const double middle = (whole.knots[i] + whole.knots[i + 1]) / 2;
        p.knots.push_back(to);
        p.pieces.push_back(shifted(whole.pieces[i], (from + to) / 2 - middle));
    }
    return p;
}

/// How a sheet bends without its flaw, 1/mm.
struct SheetForm {
    double bend_x = 0, bend_y = 0;
};

/// A face z = base_x(x) + base_y(y) + depth f(x) g(y); all by the knots of f and g.
inline NurbsSurface face_of(const Profile& f, const Profile& g, double depth,
                            const SheetForm& form) {
    const auto of = [](const Profile& p) { return p.coefficients(); };
    const auto x = of(parabola(f.knots, form.bend_x)), y = of(parabola(g.knots, form.bend_y));
    const auto fx = of(f), gy = of(g);
    const auto ramp = [](const Profile& p) {
        Profile line{p.knots, {}};
        for (std::size_t i = 0; i < p.pieces.size(); ++i)
            line.pieces.push_back({(p.knots[i] + p.knots[i + 1]) / 2, 1});
        return line.coefficients();
    };
    const auto along_x = ramp(f), along_y = ramp(g);
    constexpr int degree = profile_order - 1;
    NurbsSurface surface{degree, degree, f.knot_vector(), g.knot_vector(), {}};
    for (std::size_t i = 0; i < fx.size(); ++i)
        for (std::size_t j = 0; j < gy.size(); ++j)
            surface.points.emplace_back(along_x[i], along_y[j], x[i] + y[j] + depth * fx[i] * gy[j],
                                        1);
    return surface;
}

/// A sheet cut into faces along the lines of constant x in `cuts`, ascending.
inline SurfaceModel sheet(const Profile& f, const Profile& g, double depth, const SheetForm& form,
                          const std::vector<double>& cuts = {}) {
    std::vector<double> borders{f.knots.front()};
    borders.insert(borders.end(), cuts.begin(), cuts.end());
    borders.push_back(f.knots.back());
    ModelBuilder builder;
    for (std::size_t i = 0; i + 1 < borders.size(); ++i)
        builder.nurbs(face_of(part(f, borders[i], borders[i + 1]), g, depth, form));
    return builder.build();
}

/// 1 at `centre`, 0 from `radius` on: (1 - r^2)^4, which bends without a break.
inline Profile bump(double centre, double radius, double half = half_sheet) {
    const double q = 1 / (radius * radius);
    const Polynomial nothing{};
    return {{-half, centre - radius, centre + radius, half},
            {nothing, {1, 0, -4 * q, 0, 6 * q * q, 0, -4 * q * q * q, 0, q * q * q * q}, nothing}};
}

/// Between 1 and -1 with the period `length`: Euler's spline of degree 4.
inline Profile wave(double length, double half = half_sheet) {
    const double extent = length / 2;
    Profile p{{-half}, {}};
    double sign = 1;
    for (double at = -half; at < half - extent / 2; at += extent, sign = -sign) {
        p.knots.push_back(at + extent);
        const double q = sign / (extent * extent); // 1 - 24/5 t^2 + 16/5 t^4, t = x / extent
        p.pieces.push_back({sign, 0, -4.8 * q, 0, 3.2 * q / (extent * extent)});
    }
    return p;
}

inline Profile everywhere(double half = half_sheet) {
    return {{-half, half}, {{1}}};
}

/// The checks of dents and waves; mm.
inline std::vector<Check> checks_of_flaws(const SurfaceModel& model, double depth,
                                          double window = 100) {
    CriteriaPreset preset;
    preset.surface.waviness = {{depth, window}};
    const Inspection found = inspect(model, preset);
    std::vector<Check> checks;
    std::copy_if(found.checks.begin(), found.checks.end(), std::back_inserter(checks),
                 [](const Check& c) { return c.quantity == "dent" || c.quantity == "waviness"; });
    return checks;
}

} // namespace keiko::test
