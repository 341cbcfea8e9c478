#include "keiko/drawing/sheet/joined_strokes.h"

#include "keiko/inspect/basics/curve_chains.h"
#include "keiko/math/bounds.h"

#include <algorithm>

namespace keiko {
namespace {

/// Distance of ends that are one point, as a share of the drawing: far below what is drawn.
constexpr double same_end = 1e-5;

Vec3 in_space(const Vec2& at) {
    return {at.x, at.y, 0};
}

Stroke joined(const CurveChain& chain, const std::vector<const Stroke*>& strokes) {
    Stroke whole{strokes.front()->kind, strokes.front()->visible};
    for (const ChainLink& link : chain.links) {
        std::vector<Vec2> points = strokes[link.piece]->points;
        if (link.turned) std::reverse(points.begin(), points.end());
        const auto first = points.begin() + (whole.points.empty() ? 0 : 1);
        whole.points.insert(whole.points.end(), first, points.end());
    }
    return whole;
}

} // namespace

std::vector<Stroke> joined_strokes(const std::vector<Stroke>& strokes) {
    Box2 box;
    for (const Stroke& stroke : strokes)
        for (const Vec2& point : stroke.points) box.extend(point);
    std::vector<Stroke> result;
    for (std::size_t kind = 0; kind < curve_kinds; ++kind)
        for (const bool visible : {true, false}) {
            std::vector<const Stroke*> alike;
            std::vector<std::array<Vec3, 2>> ends;
            for (const Stroke& stroke : strokes) {
                if (stroke.kind != static_cast<CurveKind>(kind) || stroke.visible != visible)
                    continue;
                alike.push_back(&stroke);
                ends.push_back({in_space(stroke.points.front()), in_space(stroke.points.back())});
            }
            for (const CurveChain& chain : chain_curves(ends, same_end * box.size()))
                result.push_back(joined(chain, alike));
        }
    return result;
}

} // namespace keiko
