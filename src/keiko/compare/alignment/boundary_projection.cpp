#include "keiko/compare/alignment/boundary_projection.h"

#include <limits>

namespace keiko {

BoundaryProjection::BoundaryProjection(const SurfaceModel& model)
    : curves_(model), borders_(curves_.all()) {
    constexpr double chord_error = 0.05; // mm
    std::vector<Box3> boxes;
    for (std::uint32_t i = 0; i < borders_.size(); ++i) {
        polylines_.push_back(make_polyline(curve(i), chord_error));
        const CurvePolyline& line = polylines_.back();
        for (std::uint32_t k = 0; k + 1 < line.points.size(); ++k) {
            Box3 box;
            box.extend(line.points[k]);
            box.extend(line.points[k + 1]);
            boxes.push_back(box.padded(line.deviation));
            chords_.push_back({i, k});
        }
    }
    tree_.emplace(std::move(boxes));
}

std::optional<ProjectedBoundaryPoint> BoundaryProjection::foot(
    const Vec3& p, double radius, const std::function<bool(std::uint32_t face)>& counts) const {
    std::optional<ProjectedBoundaryPoint> best;
    tree_->visit_near(p, radius, [&](std::uint32_t index) {
        const Chord& chord = chords_[index];
        if (counts && !counts(borders_[chord.border].face)) return radius;
        const std::vector<double>& t = polylines_[chord.border].t;
        const double begin = t[chord.first], end = t[chord.first + 1];
        const ClosestPoint found =
            closest_point(curve(chord.border), p, (begin + end) / 2, begin, end);
        if (found.distance < radius) {
            radius = found.distance;
            best = {chord.border, found.t, found.point.position, found.distance};
        }
        return radius;
    });
    return best;
}

} // namespace keiko
