#pragma once

#include "keiko/geometry/model/closest_point.h"
#include "keiko/geometry/seam/boundary_curves.h"
#include "keiko/inspect/basics/placed_face.h"

#include <map>
#include <utility>
#include <vector>

namespace keiko {

/// The border curves of a model by their placed faces. Keeps a reference to `curves`.
class FaceBorders {
public:
    explicit FaceBorders(const BoundaryCurves& curves);

    /// The borders of a placed face, to `border_error`; empty if it has none.
    std::vector<CurvePolyline> polylines(const PlacedFace& face) const;

    static constexpr double border_error = 0.01; ///< mm

private:
    const BoundaryCurves& curves_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<BoundaryInterval>> borders_;
};

/// mm from a place to the nearest of some lines; infinity if there are none.
double distance_to(const std::vector<CurvePolyline>& lines, const Vec3& place);

} // namespace keiko
