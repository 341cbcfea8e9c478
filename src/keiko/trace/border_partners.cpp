#include "keiko/trace/border_partners.h"

#include "keiko/patch/closest_point.h"

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

} // namespace

BorderPartners::BorderPartners(const SurfaceModel& model, const BoundaryCurves& borders,
                               const Tracer& tracer)
    : model_(&model), borders_(&borders), tracer_(&tracer), uses_(edge_uses(model)) {}

std::optional<BorderPartners::Partner> BorderPartners::partner(
    const BoundaryInterval& border) const {
    if (border.curve >= natural_side) return std::nullopt;
    const std::uint32_t edge = model_->trim_curves[border.curve].edge;
    if (edge == no_index || uses_[edge].size() != 2) return std::nullopt;
    const std::vector<EdgeUse>& uses = uses_[edge];
    const EdgeUse& other = holds(uses[0], border.curve) ? uses[1] : uses[0];
    Partner partner;
    partner.widest_ = tracer_->seam_width(border.curve) *
                      least_stretch(model_->instances[border.instance].transform);
    constexpr int steps = 8;
    for (std::uint32_t c = other.first_curve; c < other.first_curve + other.curve_count; ++c) {
        const SurfaceCurve curve = borders_->curve({border.instance, other.face, c, 0, 1});
        for (int i = 0; i <= steps; ++i) {
            const double t = double(i) / steps;
            partner.samples_.push_back({partner.curves_.size(), t, curve.at(t).position});
        }
        partner.curves_.push_back(curve);
    }
    return partner;
}

std::optional<Vec3> BorderPartners::Partner::inward_at(const Vec3& place) const {
    const auto nearest =
        std::min_element(samples_.begin(), samples_.end(), [&](const Sample& a, const Sample& b) {
            return (a.position - place).length2() < (b.position - place).length2();
        });
    const SurfaceCurve& curve = curves_[nearest->curve];
    const ClosestPoint found = closest_point(curve, place, nearest->t);
    if (!(found.distance <= widest_)) return std::nullopt;
    const auto frame = curve.frame(found.t);
    return frame ? std::optional(frame->inward) : std::nullopt;
}

} // namespace keiko
