#include "keiko/light/tubes/lamp_width.h"

#include "keiko/light/tubes/cylinder_irradiance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

// Key: as in cylinder_irradiance.cpp.

namespace keiko {
namespace {

constexpr double pi = std::numbers::pi;

} // namespace

Segment LampWidth::line_of(const SubAxis& axis) const {
    const Vec3 foot = point_ + (view_.sideways * axis.sine - view_.towards * axis.cosine) * axis.r;
    return {foot + view_.along * view_.x_at(0), foot + view_.along * view_.x_at(1)};
}

bool LampWidth::middle_tells_axis() const {
    return view_.x_at(0) <= 0 && view_.x_at(1) >= 0;
}

IntervalSet LampWidth::of_axis(const IntervalSet& middle) const {
    const double begin = view_.x_at(0), length = view_.x_at(1) - begin;
    const double farther = view_.distance / sub_axis(0).r;
    const auto at = [&](double t) {
        return std::clamp(((begin + t * length) * farther - begin) / length, 0.0, 1.0);
    };
    std::vector<ParameterInterval> seen;
    for (const ParameterInterval& part : middle) seen.push_back({at(part.begin), at(part.end)});
    return IntervalSet(std::move(seen));
}

double LampWidth::lit(const SubAxis& axis, double begin, double end) const {
    const double al = view_.n_lamp * axis.cosine + view_.n_sideways * axis.sine;
    const ParameterInterval lamp{half_tangent(view_.x_at(begin), axis.r),
                                 half_tangent(view_.x_at(end), axis.r)};
    if (hiding_.empty()) return arc_integral(al, view_.n_along, lamp);
    const double psi = std::atan2(axis.sine, axis.cosine);
    double sum = 0;
    for (const ParameterInterval& open : IntervalSet(hidden_elevations(view_, hiding_, psi, axis.r))
                                             .complement(lamp.begin, lamp.end))
        sum += arc_integral(al, view_.n_along, open);
    return sum;
}

double LampWidth::place_in(const Vec3& way) const {
    return place_of(std::atan2(way.dot(view_.sideways), -way.dot(view_.towards)));
}

std::vector<double> LampWidth::cuts() const {
    std::vector<double> cuts{-1, 1};
    for (const OccludingTube& tube : hiding_)
        for (const double psi : tube.kinks(view_.radius))
            if (const double place = place_of(psi); std::abs(place) < 1) cuts.push_back(place);
    std::sort(cuts.begin(), cuts.end());
    return cuts;
}

/// Place of a wedge angle across the lamp; beyond [-1, 1] it is beside the lamp.
double LampWidth::place_of(double psi) const {
    const double ratio = view_.radius / view_.distance;
    if (shape_ == TubeShape::rectangle) return std::tan(psi) / ratio;
    const double sine = std::sin(psi) / ratio;
    return std::abs(sine) < 1 ? std::asin(sine) / (pi / 2) : std::copysign(2, sine);
}

/// The near side of the tube: sin psi = (R / D) sin (pi / 2 place), smooth up to the outline.
SubAxis LampWidth::on_tube(double place) const {
    const double ratio = view_.radius / view_.distance, s = pi / 2 * place;
    const double sine = ratio * std::sin(s), cosine = std::sqrt((1 - sine) * (1 + sine));
    return {cosine, sine, view_.distance * cosine - view_.radius * std::cos(s),
            pi / 2 * ratio * std::cos(s) / cosine};
}

SubAxis LampWidth::on_rectangle(double place) const {
    const double ratio = view_.radius / view_.distance, r = std::hypot(1, ratio * place);
    return {1 / r, ratio * place / r, view_.distance * r, ratio / (r * r)};
}

} // namespace keiko
