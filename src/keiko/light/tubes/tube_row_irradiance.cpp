#include "keiko/light/tubes/tube_row_irradiance.h"

#include "keiko/light/tubes/tube_irradiance.h"
#include "keiko/light/tubes/tube_lamp.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

bool sub_patches_hidden_out(TubeModel model) {
    return model != TubeModel::nishita && model != TubeModel::rectangle && model != TubeModel::line;
}

} // namespace

TubeRowIrradiance::TubeRowIrradiance(const CPlaneFrame& frame, const Vec3& point,
                                     const Vec3& normal, TubeModel model)
    : frame_(frame), point_(point), normal_(normal), at_(frame.point(point)), model_(model) {
    if (frame.lamps < 2 || !sub_patches_hidden_out(model) || surely_apart()) return;
    wedges_.reserve(static_cast<std::size_t>(frame.lamps));
    for (int i = 0; i < frame.lamps; ++i) wedges_.push_back(wedge_of(i));
    if (std::adjacent_find(wedges_.begin(), wedges_.end(), overlap) == wedges_.end())
        wedges_.clear();
}

bool TubeRowIrradiance::overlap(const Wedge& a, const Wedge& b) {
    return std::abs(a.angle - b.angle) < a.half + b.half;
}

/// Wedge of a lamp. A point within an endless tube, beyond an end, has that lamp in all directions.
TubeRowIrradiance::Wedge TubeRowIrradiance::wedge_of(int lamp) const {
    const double across = frame_.axis(lamp) - at_.y, distance = std::hypot(across, at_.z);
    const double half =
        distance > frame_.radius() ? std::asin(frame_.radius() / distance) : std::numbers::pi;
    return {std::atan2(across, std::abs(at_.z)), half, distance};
}

/// True if the point is far enough from the plane that no line through it meets two tubes: the
/// cosine of such a line's angle to the perpendicular is at most d / pitch.
bool TubeRowIrradiance::surely_apart() const {
    const double cosine = frame_.diameter / frame_.pitch;
    if (!(cosine < 1)) return false;
    const double aside = std::max(std::abs(frame_.first - at_.y), std::abs(frame_.last() - at_.y));
    return std::abs(at_.z) * std::sqrt(1 - cosine * cosine) > frame_.radius() + aside * cosine;
}

/// Tubes whose wedges overlap that of the lamp.
std::vector<OccludingTube> TubeRowIrradiance::hiding_tubes(int lamp) const {
    std::vector<OccludingTube> hiding;
    if (!overlapping()) return hiding;
    const double sense = at_.z > 0 ? -1 : 1; // of `sideways` viewed from either side of the plane
    const Wedge& own = wedges_[static_cast<std::size_t>(lamp)];
    for (const Wedge& other : wedges_)
        if (&other != &own && overlap(own, other))
            hiding.push_back({other.distance, sense * (other.angle - own.angle)});
    return hiding;
}

double TubeRowIrradiance::solid_angle(int lamp, const IntervalSet& visible) const {
    if (visible.empty()) return 0;
    const TubeLamp tube = lamp_of(frame_, lamp, Rgb());
    const std::vector<OccludingTube> hiding = hiding_tubes(lamp);
    if (hiding.empty()) return projected_solid_angle(tube, point_, normal_, visible, model_);
    const double cap = cap_solid_angle(tube, point_, normal_, visible);
    const auto view = view_of(tube, point_, normal_);
    if (!view) return cap;
    return cap + sum_over_parts(*view, visible, [&](const VisiblePart& part) {
               return cylinder_solid_angle(*view, part, hiding);
           });
}

} // namespace keiko
