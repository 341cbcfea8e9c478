#include "keiko/inspect/basics/placed_patch.h"

#include <algorithm>
#include <cmath>

namespace keiko {

PlacedPatch::PlacedPatch(const SurfaceModel& model, std::uint32_t patch, const Affine& placed)
    : index(patch) {
    double weight = 0;
    for (const Vec4& p : model.patch(patch).points) {
        points.push_back(placed.homogeneous(p));
        const Vec4& q = points.back();
        box.extend(euclidean(q));
        weight = std::max(weight, q.w);
    }
    middle = box.center();
    for (Vec4& p : points) p -= Vec4(middle.x * p.w, middle.y * p.w, middle.z * p.w, 0);
    constexpr double relative_rounding = 2.5e-16;
    const double reach = std::max({std::abs(middle.x), std::abs(middle.y), std::abs(middle.z)});
    rounding = relative_rounding * (reach + box.extent().length()) * weight;
}

} // namespace keiko
