#include "keiko/light/tubes/cylinder_irradiance.h"

#include "keiko/math/quadrature.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace keiko {

std::array<double, 2> OccludingTube::kinks(double radius) const {
    const double half = std::asin(std::min(radius / distance, 1.0));
    return {angle - half, angle + half};
}

std::vector<ParameterInterval> hidden_elevations(const TubeView& view,
                                                 std::span<const OccludingTube> hiding, double psi,
                                                 double near) {
    std::vector<ParameterInterval> hidden;
    for (const OccludingTube& tube : hiding) {
        const double across = tube.distance * std::sin(psi - tube.angle);
        const double middle = tube.distance * std::cos(psi - tube.angle);
        if (!(std::abs(across) < view.radius)) continue;
        const double half = std::sqrt((view.radius - across) * (view.radius + across));
        const double front = std::max(middle - half, 0.0), back = middle + half;
        if (!(back > 0) || !(front < near)) continue;
        const double begin = view.x_a, end = view.x_a + view.length;
        hidden.push_back({std::min(half_tangent(begin, front), half_tangent(begin, back)),
                          std::max(half_tangent(end, front), half_tangent(end, back))});
    }
    return hidden;
}

// Key: a half-plane through the line parallel to the axis through the point has the wedge angle psi
// from the direction of the axis, sin psi = (R / D) sin t. In t everything is smooth up to the
// tube's outline t = +-pi/2. In that half-plane, eta is the elevation towards the lamp's end b.
namespace {

constexpr double pi = std::numbers::pi;

/// Outer variables at which the integrand has a kink, with the ends of the range.
class Pieces {
public:
    explicit Pieces(const TubeView& view) : sine_limit_(view.radius / view.distance) {}

    /// Adds the half-plane with the tangent y / x, if it meets the tube.
    void split_at(double y, double x) {
        const double sine = std::copysign(y, x * y) / std::hypot(x, y) / sine_limit_;
        if (std::abs(sine) < 1) ends_.push_back(std::asin(sine));
    }
    template <class F>
    double integrate(const F& f, int nodes) {
        std::sort(ends_.begin(), ends_.end());
        double sum = 0;
        for (std::size_t i = 0; i + 1 < ends_.size(); ++i)
            if (ends_[i] < ends_[i + 1]) sum += keiko::integrate(f, ends_[i], ends_[i + 1], nodes);
        return sum;
    }

private:
    double sine_limit_;
    std::vector<double> ends_{-pi / 2, pi / 2};
};

/// Splits where the tangent plane crosses the rim at x: a chord of the circle. At most two places.
void split_at_rim(Pieces& pieces, const TubeView& view, double x) {
    const double n_towards = -view.n_lamp;
    const double lever = std::hypot(n_towards, view.n_sideways) * view.radius;
    const double cosine = (view.distance * n_towards - view.n_along * x) / lever;
    if (!(std::abs(cosine) < 1)) return;
    const double middle = std::atan2(view.n_sideways, n_towards), half = std::acos(cosine);
    for (const double phi : {middle - half, middle + half})
        pieces.split_at(view.radius * std::sin(phi), view.distance - view.radius * std::cos(phi));
}

/// Splits where the tangent plane crosses a radial cut through the axis at x.
void split_at_cut(Pieces& pieces, const TubeView& view, double x) {
    const double height = view.n_lamp * view.distance + view.n_along * x;
    pieces.split_at(-height, view.n_sideways * view.distance);
}

/// Splits at the kinks of another tube. If the point is very near to the endless tube's surface, it
/// splits ever closer to them, as the bends on either side are as sharp.
void split_at_kinks(Pieces& pieces, const TubeView& view, const OccludingTube& tube) {
    constexpr double sharp = 0.25, farthest = 1;
    const double share = view.radius / tube.distance;
    const double bend = std::sqrt(std::abs(1 - share * share)); // radians, how wide it is
    for (const double kink : tube.kinks(view.radius)) {
        const auto split = [&](double psi) { pieces.split_at(std::sin(psi), std::cos(psi)); };
        split(kink);
        if (!(bend < sharp)) continue;
        for (double off = std::max(bend, 1e-6); off < farthest; off *= 4)
            split(kink - off), split(kink + off);
    }
}

Pieces pieces_of(const TubeView& view, const VisiblePart& part,
                 std::span<const OccludingTube> hiding) {
    Pieces pieces(view);
    pieces.split_at(-view.n_lamp, view.n_sideways);
    part.begins ? split_at_rim(pieces, view, part.begin) : split_at_cut(pieces, view, part.begin);
    part.ends ? split_at_rim(pieces, view, part.end) : split_at_cut(pieces, view, part.end);
    for (const OccludingTube& tube : hiding) split_at_kinks(pieces, view, tube);
    return pieces;
}

} // namespace

double cylinder_solid_angle(const TubeView& view, const VisiblePart& part,
                            std::span<const OccludingTube> hiding, int nodes) {
    const double sine_limit = view.radius / view.distance;
    const auto slice = [&](double t) {
        const double sine = sine_limit * std::sin(t);
        const double cosine = std::sqrt((1 - sine) * (1 + sine));
        const double near = view.distance * cosine - view.radius * std::cos(t);
        const double cut = view.distance / cosine; // of the plane through the axis
        const ParameterInterval lamp{half_tangent(part.begin, part.begins ? near : cut),
                                     half_tangent(part.end, part.ends ? near : cut)};
        const double al = view.n_lamp * cosine + view.n_sideways * sine;
        double lit = 0;
        if (hiding.empty()) {
            lit = arc_integral(al, view.n_along, lamp);
        } else {
            const IntervalSet hidden(hidden_elevations(view, hiding, std::asin(sine), near));
            for (const ParameterInterval& open : hidden.complement(lamp.begin, lamp.end))
                lit += arc_integral(al, view.n_along, open);
        }
        return lit * sine_limit * std::cos(t) / cosine;
    };
    return pieces_of(view, part, hiding).integrate(slice, nodes);
}

} // namespace keiko
