#include "keiko/raster/second_derivative_bounds.h"

#include "keiko/geometry/bezier/patch_height.h"

#include <algorithm>
#include <array>

namespace keiko {
namespace {

/// Parts of a patch a side over which derivatives are bounded: bounds of a part are tighter.
constexpr int parts = 4;

} // namespace

Box2 SpanCells::box(int i, int j) const {
    return {Vec2(double(i) / u, double(j) / v), Vec2(double(i + 1) / u, double(j + 1) / v)};
}

SecondDerivativeBounds SecondDerivativeBounds::of(const BezierPatchView& patch) {
    const std::array heights{PatchHeight(patch, {Vec3(1, 0, 0), 0}),
                             PatchHeight(patch, {Vec3(0, 1, 0), 0}),
                             PatchHeight(patch, {Vec3(0, 0, 1), 0})};
    SecondDerivativeBounds bounds;
    for (int i = 0; i < parts; ++i)
        for (int j = 0; j < parts; ++j) {
            Vec3 uu(0), uv(0), vv(0);
            for (unsigned k = 0; k < 3; ++k) {
                const auto slopes = heights[k].over(SpanCells{parts, parts}.box(i, j)).slopes();
                uu[k] = slopes.xx.magnitude(), uv[k] = slopes.xy.magnitude();
                vv[k] = slopes.yy.magnitude();
            }
            constexpr double per_patch = parts * parts; // by a part's own parameters before
            bounds.uu = std::max(bounds.uu, uu.length() * per_patch);
            bounds.uv = std::max(bounds.uv, uv.length() * per_patch);
            bounds.vv = std::max(bounds.vv, vv.length() * per_patch);
        }
    return bounds;
}

double SecondDerivativeBounds::deviation(const SpanCells& cells) const {
    const double u = 1.0 / cells.u, v = 1.0 / cells.v;
    return (uu * u * u + 2 * uv * u * v + vv * v * v) / 8;
}

SpanCells SecondDerivativeBounds::cells_within(double within, std::size_t most) const {
    SpanCells cells;
    while (!(deviation(cells) <= within) && cells.count() <= most) {
        const double by_u = uu / (double(cells.u) * cells.u);
        const double by_v = vv / (double(cells.v) * cells.v);
        int& finer = by_u >= by_v ? cells.u : cells.v;
        finer += 1 + finer / 16;
    }
    return cells;
}

} // namespace keiko
