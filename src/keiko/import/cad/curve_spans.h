#pragma once

#include "keiko/geometry/bernstein/de_casteljau.h"
#include "keiko/geometry/bezier/parameter_map.h"
#include "keiko/geometry/bezier/space_curve.h"
#include "keiko/math/vec.h"

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace keiko::cad {

/// A rational Bezier piece of a CAD curve with homogeneous control points `P` (Vec3 in the plane,
/// Vec4 in space), and how its own parameter runs through the curve's.
template <class P>
struct CurveSpan {
    ParameterMap map;      ///< from 0 to 1 of the piece to the curve's parameter
    std::vector<P> points; ///< degree + 1 of them
};

/// The pieces of a CAD curve, in order, and how far they may be from it.
template <class P>
struct CurveSpans {
    std::vector<CurveSpan<P>> spans; ///< by rising parameter
    double approximated = 0;         ///< in the curve's unit of length; 0 where exact
};

/// A standard rational quadratic arc of the unit circle (or unit hyperbola): homogeneous points
/// (w cos, w sin, w) or (w cosh, w sinh, w).
struct UnitArc {
    ParameterMap map;           ///< from 0 to 1 of the arc to the angle
    std::array<Vec3, 3> points; ///< control points
};

/// Equal parts of [begin, end], none longer than `limit`; at least one.
inline std::vector<ParameterMap> equal_parts(ParameterMap::Kind kind, double begin, double end,
                                             double limit) {
    // Without the slack, 2 pi + 4e-13 would become five arcs.
    const int count = std::max(1, static_cast<int>(std::ceil((end - begin) / limit - 1e-9)));
    std::vector<ParameterMap> parts;
    for (int i = 0; i < count; ++i) {
        const auto at = [&](int k) { return k == count ? end : begin + (end - begin) * k / count; };
        parts.push_back({kind, at(i), at(i + 1)});
    }
    return parts;
}

/// Arcs of at most a quarter of the unit circle over the angles begin..end, radians.
inline std::vector<UnitArc> circle_arcs(double begin, double end) {
    std::vector<UnitArc> arcs;
    for (const auto& map :
         equal_parts(ParameterMap::Kind::circular, begin, end, std::numbers::pi / 2)) {
        const double middle = (map.begin + map.end) / 2, half = (map.end - map.begin) / 2;
        arcs.push_back({map,
                        {Vec3(std::cos(map.begin), std::sin(map.begin), 1),
                         Vec3(std::cos(middle), std::sin(middle), std::cos(half)),
                         Vec3(std::cos(map.end), std::sin(map.end), 1)}});
    }
    return arcs;
}

/// Arcs of the unit hyperbola (cosh, sinh), each over at most one unit of its parameter.
inline std::vector<UnitArc> hyperbola_arcs(double begin, double end) {
    std::vector<UnitArc> arcs;
    for (const auto& map : equal_parts(ParameterMap::Kind::hyperbolic, begin, end, 1.0)) {
        const double middle = (map.begin + map.end) / 2, half = (map.end - map.begin) / 2;
        arcs.push_back({map,
                        {Vec3(std::cosh(map.begin), std::sinh(map.begin), 1),
                         Vec3(std::cosh(middle), std::sinh(middle), std::cosh(half)),
                         Vec3(std::cosh(map.end), std::sinh(map.end), 1)}});
    }
    return arcs;
}

/// The part [a, b] of a Bezier curve, by blossoming; a and b may lie outside [0, 1].
template <class P>
std::vector<P> bezier_segment(const std::vector<P>& points, double a, double b) {
    const std::size_t degree = points.size() - 1;
    std::vector<P> segment;
    for (std::size_t k = 0; k <= degree; ++k) {
        std::vector<P> work = points;
        for (std::size_t level = 0; level < degree; ++level)
            blend_neighbours(work, degree - level, level < degree - k ? a : b);
        segment.push_back(work.front());
    }
    return segment;
}

/// Two values of a parameter that may be taken as one, relative to the range they lie in.
constexpr double same_parameter = 1e-12;

/// Knots written out with their multiplicity. Neighbours closer than `same_parameter` of the
/// whole range become one, so that no span is thinner than rounding.
inline std::vector<double> flat_knots(const TColStd_Array1OfReal& knots,
                                      const TColStd_Array1OfInteger& multiplicities) {
    const double merge = same_parameter * (knots.Last() - knots.First());
    std::vector<double> flat;
    for (int i = knots.Lower(); i <= knots.Upper(); ++i) {
        const bool same = !flat.empty() && knots(i) - flat.back() <= merge;
        flat.insert(flat.end(), static_cast<std::size_t>(multiplicities(i)),
                    same ? flat.back() : knots(i));
    }
    return flat;
}

/// The whole numbers k for which [begin, end] + k period overlaps [first, last]; 0 alone where
/// `period` is 0.
struct PeriodRange {
    int first = 0; ///< the least k
    int last = 0;  ///< the greatest, at least `first`

    /// Range of k for [begin, end] and [wanted_first, wanted_last]. It is never empty: without an
    /// overlap it is one number beside it.
    PeriodRange(double begin, double end, double wanted_first, double wanted_last, double period) {
        if (!(period > 0)) return;
        first = static_cast<int>(std::floor((wanted_first - end) / period)) + 1;
        last = static_cast<int>(std::ceil((wanted_last - begin) / period)) - 1;
        last = std::max(first, last);
    }
};

/// The part [first, last] of a CAD curve as rational Bezier pieces: lines, conics and splines
/// exactly, all other kinds by an approximation whose tolerance is returned. Periodic curves take
/// any range; the others are continued as their end pieces run. Throws Error for a curve that
/// cannot be converted.
CurveSpans<Vec3> curve_spans(const opencascade::handle<Geom2d_Curve>& curve, double first,
                             double last);
CurveSpans<Vec4> curve_spans(const opencascade::handle<Geom_Curve>& curve, double first,
                             double last);

} // namespace keiko::cad
