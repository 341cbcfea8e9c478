#include "keiko/geometry/bezier/nurbs.h"

#include <algorithm>

namespace keiko {
namespace {

/// Inserts `knot`, which lies in the valid domain, once [Boehm1980].
template <class P>
void insert_knot(NurbsCurve<P>& curve, double knot) {
    auto& knots = curve.knots;
    auto& points = curve.points;
    const auto degree = static_cast<std::size_t>(curve.degree);
    const auto above =
        std::upper_bound(knots.begin() + curve.degree, knots.end() - curve.degree - 1, knot);
    const auto span = static_cast<std::size_t>(above - knots.begin()) - 1;
    points.insert(points.begin() + static_cast<std::ptrdiff_t>(span), P(points[span]));
    // From the end backwards, so that a point still finds the old one before it.
    for (std::size_t i = span; i + degree > span && i > 0; --i) {
        const double a = knots[i] >= knot ? 0 : (knot - knots[i]) / (knots[i + degree] - knots[i]);
        points[i] = a == 0 ? points[i - 1] : points[i - 1] * (1 - a) + points[i] * a;
    }
    knots.insert(above, knot);
}

/// Raises every knot of the valid domain to multiplicity `degree` (the ends to degree at least).
template <class P>
void saturate_knots(NurbsCurve<P>& curve) {
    const auto degree = static_cast<std::size_t>(curve.degree);
    std::vector<double> distinct(curve.knots.begin() + curve.degree,
                                 curve.knots.end() - curve.degree);
    distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
    curve.knots.reserve(curve.knots.size() + distinct.size() * degree);
    curve.points.reserve(curve.points.size() + distinct.size() * degree);
    for (const double knot : distinct) {
        const auto [first, last] = std::equal_range(curve.knots.begin(), curve.knots.end(), knot);
        for (auto have = static_cast<std::size_t>(last - first); have < degree; ++have)
            insert_knot(curve, knot);
    }
}

/// Parameters of a Bezier segment in a curve whose knots are saturated.
struct SpanPlace {
    double begin = 0, end = 1;
    std::size_t first_point = 0;
};

template <class P>
std::vector<SpanPlace> span_places(const NurbsCurve<P>& saturated) {
    const auto degree = static_cast<std::size_t>(saturated.degree);
    const double domain_begin = saturated.knots[degree];
    const double domain_end = saturated.knots[saturated.points.size()];
    std::vector<SpanPlace> places;
    for (std::size_t i = degree; i < saturated.points.size(); ++i) {
        const double begin = saturated.knots[i], end = saturated.knots[i + 1];
        if (begin < end && begin >= domain_begin && end <= domain_end)
            places.push_back({begin, end, i - degree});
    }
    return places;
}

/// Columns of control points (u runs along them) with the knots of u saturated.
std::vector<NurbsCurve<Vec4>> saturated_columns(const NurbsSurface& surface) {
    const std::size_t count_u = surface.count_u(), count_v = surface.count_v();
    std::vector<NurbsCurve<Vec4>> columns;
    for (std::size_t j = 0; j < count_v; ++j) {
        NurbsCurve<Vec4> column{surface.degree_u, surface.knots_u, {}};
        for (std::size_t i = 0; i < count_u; ++i)
            column.points.push_back(surface.points[i * count_v + j]);
        saturate_knots(column);
        columns.push_back(std::move(column));
    }
    return columns;
}

} // namespace

template <class P>
std::vector<BezierSpan<P>> bezier_spans(NurbsCurve<P> curve) {
    saturate_knots(curve);
    std::vector<BezierSpan<P>> spans;
    for (const SpanPlace& place : span_places(curve)) {
        const auto first = curve.points.begin() + static_cast<std::ptrdiff_t>(place.first_point);
        spans.push_back({place.begin, place.end, {first, first + curve.degree + 1}});
    }
    return spans;
}

template std::vector<BezierSpan<Vec3>> bezier_spans(NurbsCurve<Vec3>);
template std::vector<BezierSpan<Vec4>> bezier_spans(NurbsCurve<Vec4>);

std::vector<BezierPatchSpan> bezier_spans(const NurbsSurface& surface) {
    const auto order_u = static_cast<std::size_t>(surface.degree_u) + 1;
    const auto order_v = static_cast<std::size_t>(surface.degree_v) + 1;
    const std::vector<NurbsCurve<Vec4>> columns = saturated_columns(surface);
    std::vector<BezierPatchSpan> patches;
    for (const SpanPlace& in_u : span_places(columns.front())) {
        const std::size_t first = patches.size();
        for (std::size_t i = 0; i < order_u; ++i) {
            NurbsCurve<Vec4> row{surface.degree_v, surface.knots_v, {}};
            for (const auto& column : columns)
                row.points.push_back(column.points[in_u.first_point + i]);
            const std::vector<BezierSpan<Vec4>> spans = bezier_spans(std::move(row));
            for (std::size_t r = 0; r < spans.size(); ++r) {
                const BezierSpan<Vec4>& in_v = spans[r];
                if (i == 0) patches.push_back({in_u.begin, in_u.end, in_v.begin, in_v.end, {}});
                std::vector<Vec4>& points = patches[first + r].points;
                points.reserve(order_u * order_v);
                points.insert(points.end(), in_v.points.begin(), in_v.points.end());
            }
        }
    }
    return patches;
}

} // namespace keiko
