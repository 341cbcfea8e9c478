#pragma once

#include "keiko/geometry/bernstein/bernstein_roots.h"
#include "keiko/visibility/boundaries/boundary_piece.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keiko {

/// Bernstein coefficients of the distance of a border piece to a plane.
using PlaneDistances = std::array<double, BoundaryPiece::points>;

/// Where a piece of a border meets a plane.
struct PlaneCut {
    double t = 0;
    /// 1 where the distance rises through zero, -1 where it falls; 0 where that is not known.
    int rising = 0;
};

int sign_changes(const PlaneDistances& c);
/// Of coefficients that change sign once: the zero, by Newton's method kept inside until it moves
/// by no more than `settled`, the step after which is about its square.
double single_zero(const PlaneDistances& c, double settled);
std::array<PlaneDistances, 2> halved(const PlaneDistances& c);
/// The derivative over 5, of the same degree.
PlaneDistances slope_of(const PlaneDistances& c);
/// The value at t.
double value_at(const PlaneDistances& c, double t);

/// Calls `visit(PlaneCut)` for the zeros, of coefficients over [begin, end].
template <class Visit>
void each_zero(const PlaneDistances& c, double begin, double end, double settled, int most_halvings,
               const Visit& visit) {
    const int changes = sign_changes(c);
    if (changes == 0) return;
    const auto at = [&](double t) { return begin + (end - begin) * t; };
    if (changes == 1)
        return visit(PlaneCut{at(single_zero(c, settled)), c.back() > c.front() ? 1 : -1});
    if (most_halvings == 0) {
        const PlaneDistances slope = slope_of(c);
        for (const double t : bernstein_roots(c, 0))
            visit(PlaneCut{at(t), value_at(slope, t) > 0 ? 1 : -1});
        return;
    }
    const std::array halves = halved(c);
    each_zero(halves[0], begin, at(0.5), settled, most_halvings - 1, visit);
    each_zero(halves[1], at(0.5), end, settled, most_halvings - 1, visit);
}

/// Calls `visit(PlaneCut)` where the curve turns back within `slack` of the plane.
template <class Visit>
void each_touch(const PlaneDistances& c, double begin, double end, double slack, int most_halvings,
                const Visit& visit) {
    const auto [low, high] = std::minmax_element(c.begin(), c.end());
    if (*low > slack || *high < -slack) return;
    const PlaneDistances slope = slope_of(c);
    const int turns = sign_changes(slope);
    if (turns == 0) return;
    if (turns == 1) {
        constexpr double settled = 1e-9;
        const double t = single_zero(slope, settled);
        if (std::abs(value_at(c, t)) <= slack) visit(PlaneCut{begin + (end - begin) * t, 0});
        return;
    }
    if (most_halvings == 0) return;
    const std::array halves = halved(c);
    const double middle = (begin + end) / 2;
    each_touch(halves[0], begin, middle, slack, most_halvings - 1, visit);
    each_touch(halves[1], middle, end, slack, most_halvings - 1, visit);
}

/// Calls `visit(PlaneCut)` wherever rays in the plane may begin or cease to meet what is within
/// `slack` mm of the curve: its zeros, places where it turns back at the plane, and its ends at the
/// plane, where pieces meet within rounding and a zero belongs to both. A curve that lies in the
/// plane as a whole has its ends alone: signs along it are rounding, and rays may meet it or not.
template <class Visit>
void each_cut(const PlaneDistances& c, double slack, double settled, const Visit& visit) {
    const auto [low, high] = std::minmax_element(c.begin(), c.end());
    if (*low > slack || *high < -slack) return;
    if (std::abs(c.front()) <= slack) visit(PlaneCut{0, 0});
    if (std::abs(c.back()) <= slack) visit(PlaneCut{1, 0});
    if (*low >= -slack && *high <= slack) return;
    constexpr int most_halvings = 8;
    each_touch(c, 0, 1, slack, most_halvings, visit);
    each_zero(c, 0, 1, settled, most_halvings, visit);
}

} // namespace keiko
