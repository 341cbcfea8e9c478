#include "keiko/patch/nurbs.h"

#include <algorithm>

namespace keiko {
namespace {

/// Inserts `knot`, which lies in the valid domain, once (Boehm 1980).
template <class P>
void insert_knot(NurbsCurve<P>& curve, double knot) {
    const auto degree = static_cast<std::size_t>(curve.degree);
    auto& knots = curve.knots;
    const auto above =
        std::upper_bound(knots.begin() + curve.degree, knots.end() - curve.degree - 1, knot);
    const auto span = static_cast<std::size_t>(above - knots.begin()) - 1;
    std::vector<P> points;
    points.reserve(curve.points.size() + 1);
    for (std::size_t i = 0; i <= curve.points.size(); ++i) {
        if (i + degree <= span) {
            points.push_back(curve.points[i]);
        } else if (i > span || knots[i] >= knot) {
            points.push_back(curve.points[i - 1]);
        } else {
            const double a = (knot - knots[i]) / (knots[i + degree] - knots[i]);
            points.push_back(curve.points[i - 1] * (1 - a) + curve.points[i] * a);
        }
    }
    knots.insert(above, knot);
    curve.points = std::move(points);
}

/// Raises every knot of the valid domain to multiplicity `degree` (the ends to degree at least).
template <class P>
void saturate_knots(NurbsCurve<P>& curve) {
    const auto degree = static_cast<std::size_t>(curve.degree);
    std::vector<double> distinct(curve.knots.begin() + curve.degree,
                                 curve.knots.end() - curve.degree);
    distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
    for (const double knot : distinct) {
        const auto [first, last] = std::equal_range(curve.knots.begin(), curve.knots.end(), knot);
        for (auto have = static_cast<std::size_t>(last - first); have < degree; ++have)
            insert_knot(curve, knot);
    }
}

} // namespace

template <class P>
std::vector<BezierSpan<P>> bezier_spans(NurbsCurve<P> curve) {
    const auto degree = static_cast<std::size_t>(curve.degree);
    saturate_knots(curve);
    const double domain_begin = curve.knots[degree];
    const double domain_end = curve.knots[curve.points.size()];
    std::vector<BezierSpan<P>> spans;
    for (std::size_t i = degree; i < curve.points.size(); ++i) {
        const double begin = curve.knots[i], end = curve.knots[i + 1];
        if (!(begin < end) || begin < domain_begin || end > domain_end) continue;
        const auto first = curve.points.begin() + static_cast<std::ptrdiff_t>(i - degree);
        spans.push_back({begin, end, {first, first + curve.degree + 1}});
    }
    return spans;
}

template std::vector<BezierSpan<Vec3>> bezier_spans(NurbsCurve<Vec3>);
template std::vector<BezierSpan<Vec4>> bezier_spans(NurbsCurve<Vec4>);

std::vector<BezierPatchSpan> bezier_spans(const NurbsSurface& surface) {
    const std::size_t count_u = surface.count_u(), count_v = surface.count_v();
    const auto order_u = static_cast<std::size_t>(surface.degree_u) + 1;
    const auto order_v = static_cast<std::size_t>(surface.degree_v) + 1;

    // columns[v index][u span]
    std::vector<std::vector<BezierSpan<Vec4>>> columns;
    for (std::size_t j = 0; j < count_v; ++j) {
        NurbsCurve<Vec4> column{surface.degree_u, surface.knots_u, {}};
        for (std::size_t i = 0; i < count_u; ++i)
            column.points.push_back(surface.points[i * count_v + j]);
        columns.push_back(bezier_spans(std::move(column)));
    }

    std::vector<BezierPatchSpan> patches;
    for (std::size_t s = 0; s < columns.front().size(); ++s) {
        const std::size_t first = patches.size();
        for (std::size_t i = 0; i < order_u; ++i) {
            NurbsCurve<Vec4> row{surface.degree_v, surface.knots_v, {}};
            for (const auto& column : columns) row.points.push_back(column[s].points[i]);
            const auto spans = bezier_spans(std::move(row));
            for (std::size_t r = 0; r < spans.size(); ++r) {
                if (i == 0)
                    patches.push_back({columns[0][s].begin, columns[0][s].end, spans[r].begin,
                                       spans[r].end, std::vector<Vec4>(order_u * order_v)});
                std::copy(
                    spans[r].points.begin(), spans[r].points.end(),
                    patches[first + r].points.begin() + static_cast<std::ptrdiff_t>(i * order_v));
            }
        }
    }
    return patches;
}

} // namespace keiko
