#include "keiko/inspect/overlaps/face_borders.h"

#include <algorithm>
#include <limits>

namespace keiko {

FaceBorders::FaceBorders(const BoundaryCurves& curves) : curves_(curves) {
    for (const BoundaryInterval& border : curves.all())
        borders_[{border.instance, border.face}].push_back(border);
}

std::vector<CurvePolyline> FaceBorders::polylines(const PlacedFace& face) const {
    std::vector<CurvePolyline> lines;
    const auto found = borders_.find({face.instance, face.face});
    if (found == borders_.end()) return lines;
    for (const BoundaryInterval& border : found->second)
        lines.push_back(make_polyline(curves_.curve(border), border_error));
    return lines;
}

double distance_to(const std::vector<CurvePolyline>& lines, const Vec3& place) {
    double least = std::numeric_limits<double>::infinity();
    for (const CurvePolyline& line : lines) least = std::min(least, line.distance(place));
    return least;
}

} // namespace keiko
