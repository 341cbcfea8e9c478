#pragma once

#include "keiko/geometry/model/closest_point.h"

#include <vector>

namespace keiko {

/// A border curve prepared for searching.
struct Border {
    SurfaceCurve curve;     ///< the exact curve, world, mm
    CurvePolyline polyline; ///< chords near the curve, for the search
};

/// Two points of two borders that face each other.
struct FacingPoints {
    double t = 0, s = 0;  ///< on the first and on the second border
    double distance = 0;  ///< mm
    bool overlap = false; ///< one of them lies on the other's material: no gap, a sliver's far side
};

/// A maximal stretch along which two borders face each other within the join distance, running
/// nearly parallel.
struct Stretch {
    std::vector<FacingPoints> points; ///< at least two; t strictly rising, s rising or falling so
};

/// All stretches of `a` along `b`. Ends are exact: an end of either curve, or the place where the
/// distance passes `join` mm.
std::vector<Stretch> stretches_alongside(const Border& a, const Border& b, double join);

/// Share of the join distance below which distances do not distinguish two candidates.
constexpr double indistinct_share = 1e-3;

} // namespace keiko
