#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/seam/boundary_curves.h"
#include "keiko/math/bounds.h"

#include <map>
#include <utility>

namespace KEIKO_API keiko {

/// Sizes of placed faces: mm, the diagonal of the box of five places on each of a face's border
/// curves. A size depends on the face alone.
class FaceSizes {
public:
    /// Sizes of the faces that these curves bound.
    explicit FaceSizes(const BoundaryCurves& curves);

    /// Size of a placed face; 0 if it has no borders.
    double of(std::uint32_t instance, std::uint32_t face) const;

private:
    std::map<std::pair<std::uint32_t, std::uint32_t>, Box3> boxes_;
};

/// The border curves of a model and the sizes of its placed faces: made once, for everything that
/// needs seams and free edges. A model converts to it for a single query. Keeps a reference to the
/// model.
struct ModelBorders {
    /// Borders of a model, to which a reference is kept.
    ModelBorders(const SurfaceModel& of) : model(of), curves(of), sizes(curves) {}

    const SurfaceModel& model; ///< the model itself
    BoundaryCurves curves;     ///< its borders in space
    FaceSizes sizes;           ///< of its faces
};

inline FaceSizes::FaceSizes(const BoundaryCurves& curves) {
    for (const BoundaryInterval& border : curves.all()) {
        const SurfaceCurve curve = curves.curve(border);
        Box3& box = boxes_[{border.instance, border.face}];
        for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) box.extend(curve.at(t).position);
    }
}

inline double FaceSizes::of(std::uint32_t instance, std::uint32_t face) const {
    const auto found = boxes_.find({instance, face});
    return found == boxes_.end() ? 0 : found->second.size();
}

} // namespace keiko
