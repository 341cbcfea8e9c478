#include "keiko/inspect/seams/knot_piece.h"

#include "keiko/inspect/seams/curvature_match.h"

#include <cmath>

namespace keiko {

Vec3 KnottedFace::point(const Vec2& parameters) const {
    const std::uint32_t index = grid_.locate(parameters, Vec2(0));
    const Patch& patch = model_.patches[index];
    const Vec2 uv(patch.map_u.to_patch(parameters.x), patch.map_v.to_patch(parameters.y));
    return evaluate(model_.patch(index), uv, 0).position();
}

SeamProbe KnottedFace::probe(const KnotPiece& piece, const Affine& placed,
                             const std::array<Vec3, 2>& left,
                             const std::array<Vec3, 2>& right) const {
    const SurfaceCurve a(model_, grid_, placed, {left}, true);
    const SurfaceCurve b(model_, grid_, placed, {right}, false);
    return piece.is_bend() ? SeamProbe::across_bend(a, b) : SeamProbe(a, {0, 1}, b, {0, 1});
}

bool breaks_at(const SeamPoint& p) {
    constexpr double gap = 1e-4, angle = 1e-4, share = 1e-3, change = 2e-7;
    constexpr double unlimited_radius = HUGE_VAL; // mm: `change` identifies flat sides
    if (p.gap > gap) return true;
    if (!p.angle) return false;
    return *p.angle > angle || (std::abs(p.curvature_a - p.curvature_b) > change &&
                                curvature_mismatch(CurvatureFormula::catia, p.curvature_a,
                                                   p.curvature_b, unlimited_radius) > share);
}

} // namespace keiko
