#include "keiko/geometry/bezier/bezier.h"
#include "keiko/import/cad/trim_chains.h"

#include <algorithm>

namespace keiko::cad {
namespace {

using Polygon = std::vector<Vec2>;

/// The direction of a loop survives coarse sampling.
Polygon polygon_of(const Chain& loop) {
    Polygon polygon;
    for (const LoopCurve& curve : loop) {
        const int chords = curve.points.size() == 2 ? 1 : 8;
        for (int i = 0; i < chords; ++i)
            polygon.push_back(evaluate(BezierCurveView{curve.points}, double(i) / chords, 0)[0]);
    }
    return polygon;
}

double signed_area(const Polygon& polygon) {
    double sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 a = polygon[i] - polygon[0];
        const Vec2 b = polygon[(i + 1) % polygon.size()] - polygon[0];
        sum += a.x * b.y - a.y * b.x;
    }
    return sum / 2;
}

bool contains(const Polygon& polygon, const Vec2& p) {
    bool inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        if ((a.y <= p.y) == (b.y <= p.y)) continue;
        if (p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
    }
    return inside;
}

/// By the majority of its corners: loops may touch.
bool lies_in(const Polygon& inner, const Polygon& outer) {
    const auto inside = std::count_if(inner.begin(), inner.end(),
                                      [&](const Vec2& p) { return contains(outer, p); });
    return 2 * static_cast<std::size_t>(inside) > inner.size();
}

} // namespace

std::size_t backward_loops(const std::vector<Chain>& loops) {
    std::vector<Polygon> polygons;
    for (const Chain& loop : loops) polygons.push_back(polygon_of(loop));
    std::size_t backward = 0;
    for (const Polygon& polygon : polygons) {
        const auto depth = std::count_if(
            polygons.begin(), polygons.end(),
            [&](const Polygon& other) { return &other != &polygon && lies_in(polygon, other); });
        const double area = signed_area(polygon);
        backward += depth % 2 == 0 ? area < 0 : area > 0;
    }
    return backward;
}

} // namespace keiko::cad
