#include "keiko/visibility/boundaries/adjacent_faces.h"

#include "keiko/geometry/model/closest_point.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Bound of what a placement leaves of a length.
double least_stretch(const Affine& placement) {
    if (placement.is_identity()) return 1;
    double squares = 0;
    for (const Vec3& row : placement.inverse().rows) squares += row.length2();
    return 1 / std::sqrt(squares);
}

bool holds(const EdgeUse& use, std::uint32_t curve) {
    return curve >= use.first_curve && curve - use.first_curve < use.curve_count;
}

constexpr int steps = 8;

Box3 box_of(const SurfaceCurve& curve) {
    Box3 box;
    for (int i = 0; i <= steps; ++i) box.extend(curve.at(double(i) / steps).position);
    return box;
}

/// Share of the coordinates below which two places are one.
constexpr double same_place = 1e-10;

} // namespace

AdjacentFaces::AdjacentFaces(const SurfaceModel& model, const BoundaryCurves& borders,
                             const Tracer& tracer)
    : model_(&model),
      borders_(&borders),
      tracer_(&tracer),
      uses_(edge_uses(model)),
      loose_(borders.all()),
      loose_boxes_(loose_boxes()) {}

std::vector<Box3> AdjacentFaces::loose_boxes() {
    std::erase_if(loose_, [&](const BoundaryInterval& border) { return has_edge(border); });
    std::vector<Box3> boxes;
    for (const BoundaryInterval& border : loose_) boxes.push_back(box_of(borders_->curve(border)));
    return boxes;
}

bool AdjacentFaces::has_edge(const BoundaryInterval& border) const {
    if (border.curve >= natural_side) return false;
    const std::uint32_t edge = model_->trim_curves[border.curve].edge;
    return edge != no_index && uses_[edge].size() > 1;
}

std::optional<AdjacentFaces::Partner> AdjacentFaces::partner(const BoundaryInterval& border) const {
    return has_edge(border) ? across_edge(border) : same_curve(border);
}

std::optional<AdjacentFaces::Partner> AdjacentFaces::across_edge(
    const BoundaryInterval& border) const {
    const std::vector<EdgeUse>& uses = uses_[model_->trim_curves[border.curve].edge];
    if (uses.size() != 2) return std::nullopt;
    const EdgeUse& other = holds(uses[0], border.curve) ? uses[1] : uses[0];
    Partner partner(tracer_->seam_width(border.curve) *
                    least_stretch(model_->instances[border.instance].transform));
    for (std::uint32_t c = other.first_curve; c < other.first_curve + other.curve_count; ++c)
        partner.add(borders_->curve({border.instance, other.face, c, 0, 1}));
    return partner;
}

std::optional<AdjacentFaces::Partner> AdjacentFaces::same_curve(
    const BoundaryInterval& border) const {
    const SurfaceCurve curve = borders_->curve(border);
    const Box3 box = box_of(curve);
    const double widest = same_place * (box.size() + box.center().length());
    std::optional<Partner> found;
    for (const std::uint32_t i : loose_boxes_.overlapping(box.padded(widest))) {
        const BoundaryInterval& other = loose_[i];
        if (other.instance == border.instance && other.face == border.face) continue;
        Partner candidate(widest);
        candidate.add(borders_->curve(other));
        bool follows = true;
        for (int k = 0; k <= steps && follows; ++k)
            follows = candidate.nearest(curve.at(double(k) / steps).position).has_value();
        if (!follows) continue;
        if (found) return std::nullopt;
        found = std::move(candidate);
    }
    return found;
}

void AdjacentFaces::Partner::add(const SurfaceCurve& curve) {
    for (int i = 0; i <= steps; ++i) {
        const double t = double(i) / steps;
        samples_.push_back({curves_.size(), t, curve.at(t).position});
    }
    curves_.push_back(curve);
}

std::optional<AdjacentFaces::Partner::Foot> AdjacentFaces::Partner::nearest(
    const Vec3& place) const {
    const auto sample =
        std::min_element(samples_.begin(), samples_.end(), [&](const Sample& a, const Sample& b) {
            return (a.position - place).length2() < (b.position - place).length2();
        });
    const ClosestPoint found = closest_point(curves_[sample->curve], place, sample->t);
    if (!(found.distance <= widest_)) return std::nullopt;
    return Foot{sample->curve, found.t};
}

std::optional<Vec3> AdjacentFaces::Partner::inward_at(const Vec3& place) const {
    const auto foot = nearest(place);
    if (!foot) return std::nullopt;
    const auto frame = curves_[foot->curve].frame(foot->t);
    return frame ? std::optional(frame->inward) : std::nullopt;
}

} // namespace keiko
