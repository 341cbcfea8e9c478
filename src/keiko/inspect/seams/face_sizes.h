#pragma once

#include "keiko/geometry/seam/boundary_curves.h"
#include "keiko/math/bounds.h"

#include <map>
#include <utility>

namespace keiko {

/// Sizes of placed faces: mm, the diagonal of the box of five places on each of a face's border
/// curves. A size depends on the face alone.
class FaceSizes {
public:
    explicit FaceSizes(const BoundaryCurves& curves);

    /// Size of a placed face; 0 if it has no borders.
    double of(std::uint32_t instance, std::uint32_t face) const;

private:
    std::map<std::pair<std::uint32_t, std::uint32_t>, Box3> boxes_;
};

} // namespace keiko
