#include "keiko/geometry/trim/patch_material.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Distance from a side of a patch, as a share of the patch, within which a trim curve is assumed
/// to run along it.
constexpr double side_width = 1e-10;

/// The box, with no side much shorter than the other, within the patch.
Box2 rounded_out(const Box2& box) {
    constexpr double least_share = 1.0 / 16, least = 1e-9;
    const Vec2 extent = box.extent();
    const double side = std::max(least, least_share * std::max(extent.x, extent.y));
    Box2 wide = box;
    for (unsigned k = 0; k < 2; ++k) {
        if (extent[k] >= side) continue;
        wide.lower[k] = std::max(0.0, box.center()[k] - side / 2);
        wide.upper[k] = std::min(1.0, wide.lower[k] + side);
        wide.lower[k] = std::min(wide.lower[k], wide.upper[k] - side);
    }
    return wide;
}

} // namespace

PatchMaterial::PatchMaterial(const SurfaceModel& model, std::uint32_t patch,
                             const TrimRegion& trims, const Height& height)
    : model_(model),
      patch_(patch),
      trims_(trims),
      height_(height),
      whole_(model.patch(patch), height),
      domain_(face_box(unit_square)) {
    const Vec2 margin = domain_.extent() * side_width;
    domain_.lower -= margin, domain_.upper += margin;
}

Box2 PatchMaterial::face_box(const Box2& uv) const {
    Box2 box;
    box.extend(model_.face_parameters(patch_, uv.lower));
    box.extend(model_.face_parameters(patch_, uv.upper));
    return box;
}

Vec2 PatchMaterial::to_patch(const Vec2& face_parameters) const {
    const Patch& p = model_.patches[patch_];
    return unit_square.nearest(
        {p.map_u.to_patch(face_parameters.x), p.map_v.to_patch(face_parameters.y)});
}

bool PatchMaterial::contains(const Vec2& uv) const {
    return trims_.contains(model_.face_parameters(patch_, uv));
}

std::optional<double> PatchMaterial::height_at(const Vec2& face_parameters) const {
    if (!domain_.contains(face_parameters)) return std::nullopt;
    const Vec3 place = evaluate(model_.patch(patch_), to_patch(face_parameters), 0).position();
    return std::min(height_.of(place), whole_.upper()); // a height above the upper bound is
                                                        // rounding
}

std::optional<PatchMaterial::Overlap> PatchMaterial::overlap(const CurveStretch& stretch) const {
    const Box2 own = stretch.box(), common = own.intersection(domain_);
    if (common.empty()) return std::nullopt;
    Overlap on{{}, own == common};
    on.uv.extend(to_patch(common.lower));
    on.uv.extend(to_patch(common.upper));
    return on;
}

PatchMaterial::CurveBound PatchMaterial::bound(const CurveStretch& stretch,
                                               const Overlap& overlap) const {
    CurveBound bound{whole_.over(overlap.uv).upper()};
    const auto first = height_at(stretch.first()), last = height_at(stretch.last());
    if (!overlap.whole || !first || !last) return bound;
    const CurveStretch::Rates rates =
        stretch.rates(model_.patches[patch_], whole_.over(rounded_out(overlap.uv)));
    bound.monotone = !rates.first.holds_zero();
    // Nowhere farther above its chord than a parabola with its largest second derivative.
    const double above_chord = std::max(0.0, -rates.second.low) / 8;
    const double by_chord = std::max(*first, *last) + above_chord;
    if (by_chord < bound.upper) bound.upper = by_chord;
    return bound;
}

bool beside_material(const TrimRegion& trims, const CurveStretch& stretch, double s) {
    // Distance from the curve, in face parameters.
    constexpr double aside = 1e-10;
    const auto at = stretch.at(s);
    const Vec2 scale = trims.bounds().extent();
    const Vec2 tangent(at[1].x / scale.x, at[1].y / scale.y);
    const double length = tangent.length();
    if (!(length > 0)) return false;
    const Vec2 step = Vec2(-tangent.y * scale.x, tangent.x * scale.y) * (aside / length);
    return trims.contains(at[0] + step) || trims.contains(at[0] - step);
}

} // namespace keiko
