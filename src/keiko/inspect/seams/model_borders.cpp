#include "keiko/inspect/seams/model_borders.h"

namespace keiko {

FaceSizes::FaceSizes(const BoundaryCurves& curves) {
    for (const BoundaryInterval& border : curves.all()) {
        const SurfaceCurve curve = curves.curve(border);
        Box3& box = boxes_[{border.instance, border.face}];
        for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) box.extend(curve.at(t).position);
    }
}

double FaceSizes::of(std::uint32_t instance, std::uint32_t face) const {
    const auto found = boxes_.find({instance, face});
    return found == boxes_.end() ? 0 : found->second.size();
}

} // namespace keiko
