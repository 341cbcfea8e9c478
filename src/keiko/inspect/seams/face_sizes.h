#pragma once

#include "keiko/geometry/seam/boundary_curves.h"
#include "keiko/math/bounds.h"

#include <map>
#include <utility>

namespace keiko {

/// How large placed faces are: mm, the diagonal of the box of five places on each of a face's
/// border curves. It depends on nothing but the face.
class FaceSizes {
public:
    explicit FaceSizes(const BoundaryCurves& curves);

    /// 0 of a face without borders.
    double of(std::uint32_t instance, std::uint32_t face) const;

private:
    std::map<std::pair<std::uint32_t, std::uint32_t>, Box3> boxes_;
};

} // namespace keiko
