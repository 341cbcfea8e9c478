#include "keiko/inspect/regularity/normal_patch.h"

namespace keiko {
namespace {

/// Box of the control points of a side of a patch.
Box3 side_box(const BezierPatchView& patch, bool by_u, bool upper) {
    Box3 box;
    const int last = by_u ? patch.degree_v : patch.degree_u;
    const int fixed = !upper ? 0 : by_u ? patch.degree_u : patch.degree_v;
    for (int k = 0; k <= last; ++k) {
        box.extend(euclidean(by_u ? patch.point(fixed, k) : patch.point(k, fixed)));
    }
    return box;
}

} // namespace

NormalPatch::NormalPatch(const SurfaceModel& model, std::uint32_t patch, const Affine& placed,
                         double negligible)
    : placed_(model, patch, placed),
      degree_u_(model.patches[patch].degree_u),
      degree_v_(model.patches[patch].degree_v),
      field_(without_zero_sides(normal_field(view(), placed_.rounding))) {
    for (const bool by_u : {true, false})
        for (const bool upper : {false, true}) {
            const Box3 side = side_box(view(), by_u, upper);
            if (side.size() <= negligible) tips_.push_back(placed_.middle + side.center());
        }
}

Vec3 NormalPatch::position(const Vec2& uv) const {
    return placed_.middle + evaluate(view(), uv, 0).position();
}

std::optional<Vec3> NormalPatch::normal(const Vec2& uv) const {
    constexpr double clearly = 100; // times its rounding error
    const Vec3 n = value_at(field_, uv);
    const double rounding = field_[0].rounding() + field_[1].rounding() + field_[2].rounding();
    if (!(n.length() > clearly * rounding)) return std::nullopt;
    return n.normalized();
}

} // namespace keiko
