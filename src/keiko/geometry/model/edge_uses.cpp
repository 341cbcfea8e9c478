#include "keiko/geometry/model/edge_uses.h"

#include <algorithm>

namespace keiko {
namespace {

Vec2 end_point(const BezierCurveView& curve, bool last) {
    const Vec3& p = last ? curve.points.back() : curve.points.front();
    return {p.x / p.z, p.y / p.z};
}

bool is_way_back(const BezierCurveView& before, const BezierCurveView& own) {
    return std::equal(before.points.begin(), before.points.end(), own.points.rbegin(),
                      own.points.rend());
}

/// True if the curve continues the one before it. The other side of a seam starts elsewhere, or
/// runs back.
bool continues(const SurfaceModel& model, std::uint32_t curve) {
    const BezierCurveView before = model.trim_curve(curve - 1), own = model.trim_curve(curve);
    return model.trim_curves[curve - 1].edge == model.trim_curves[curve].edge &&
           end_point(before, true) == end_point(own, false) && !is_way_back(before, own);
}

} // namespace

std::vector<std::vector<EdgeUse>> edge_uses(const SurfaceModel& model) {
    std::vector<std::vector<EdgeUse>> uses(model.edges.size());
    for (std::uint32_t f = 0; f < model.faces.size(); ++f)
        for (const TrimLoop& loop : model.loops_of(model.faces[f]))
            for (std::uint32_t i = 0; i < loop.curve_count; ++i) {
                const std::uint32_t curve = loop.first_curve + i;
                const std::uint32_t edge = model.trim_curves[curve].edge;
                if (edge == no_index) continue;
                if (i > 0 && continues(model, curve))
                    ++uses[edge].back().curve_count;
                else
                    uses[edge].push_back({f, curve, 1});
            }
    return uses;
}

} // namespace keiko
