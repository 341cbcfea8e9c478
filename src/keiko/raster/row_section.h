#pragma once

#include "keiko/math/vec.h"
#include "keiko/raster/picture_map.h"

#include <array>

namespace keiko {

/// Section of a triangle by the plane of the eye and a row of pixels' centres, before the eye. All
/// of it lies on the triangle, however steeply that is seen.
class RowSection {
public:
    /// `row`: y of the centres in the picture, pixels. If the triangle misses the row, as its
    /// corners were rounded, the section is the corner next to it.
    RowSection(const std::array<Vec3, 3>& triangle, const PictureMap& picture, double row);

    /// Share of the way from one end, 0, to the other, 1, of the place that shows at x, pixels; of
    /// the end that is next to x in the picture, if none does.
    double share_at(double x) const;
    /// Place at a share, world, mm.
    Vec3 place(double share) const { return ends_[0] + (ends_[1] - ends_[0]) * share; }

private:
    void move_before_eye();

    std::array<Vec3, 2> ends_; ///< world, mm
    std::array<Vec3, 2> seen_; ///< in the picture, homogeneous
};

} // namespace keiko
