#include "keiko/tubes/tube_penumbra.h"

#include "keiko/tubes/arc_integral.h"
#include "keiko/tubes/tube_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

// Key: as in cylinder_irradiance.cpp. A sub-axis is the line that the half-plane at the wedge angle
// psi cuts out of the lamp, at the distance r from the point.

namespace keiko {
namespace {

constexpr double pi = std::numbers::pi;

/// Nodes of Gauss's rule of 3 and Kronrod's of 7, which holds it, on [-1, 1].
constexpr std::array<double, 4> nodes{0, 0.4342437493468026, 0.7745966692414834,
                                      0.9604912687080202};
constexpr std::array<double, 4> kronrod{0.4509165386584741, 0.4013974147759622, 0.2684880898683334,
                                        0.1046562260264673};
constexpr std::array<double, 4> gauss{0.8888888888888889, 0, 0.5555555555555556, 0};

/// A sub-axis and what it weighs.
struct SubAxis {
    double cosine, sine; ///< of psi
    double r;            ///< mm
    double weight;       ///< d psi by the variable of integration
};

class Width {
public:
    Width(const TubeView& view, const Vec3& point, const Visible& visible, TubeShape shape)
        : view_(view), point_(point), visible_(visible), shape_(shape) {}

    /// The slice at x in [-1, 1] across the lamp, and what of it is hidden.
    struct Slice {
        double all, hidden;
    };
    Slice at(double x) const {
        const SubAxis axis = sub_axis(x);
        const double all = lit(axis, 0, 1);
        if (all == 0) return {0, 0};
        const Vec3 foot =
            point_ + (view_.sideways * axis.sine - view_.towards * axis.cosine) * axis.r;
        const Segment line{foot + view_.along * view_.x_at(0), foot + view_.along * view_.x_at(1)};
        double hidden = 0;
        for (const ParameterInterval& dark : visible_.intervals(line).complement())
            hidden += lit(axis, dark.begin, dark.end);
        return {all, hidden};
    }
    /// What the slice in the middle lights of a lamp as wide as this one: the scale of errors.
    double scale() const { return 2 * lit(sub_axis(0), 0, 1); }

private:
    SubAxis sub_axis(double x) const {
        return shape_ == TubeShape::cylinder ? on_tube(x) : on_rectangle(x);
    }
    double lit(const SubAxis& axis, double begin, double end) const {
        const double al = view_.n_lamp * axis.cosine + view_.n_sideways * axis.sine;
        return axis.weight * arc_integral(al, view_.n_along, std::atan2(view_.x_at(begin), axis.r),
                                          std::atan2(view_.x_at(end), axis.r));
    }
    /// The near side of the tube: sin psi = (R / D) sin (pi x / 2), smooth up to the outline.
    SubAxis on_tube(double x) const {
        const double ratio = view_.radius / view_.distance, s = pi / 2 * x;
        const double sine = ratio * std::sin(s), cosine = std::sqrt((1 - sine) * (1 + sine));
        return {cosine, sine, view_.distance * cosine - view_.radius * std::cos(s),
                pi / 2 * ratio * std::cos(s) / cosine};
    }
    SubAxis on_rectangle(double x) const {
        const double ratio = view_.radius / view_.distance, r = std::hypot(1, ratio * x);
        return {1 / r, ratio * x / r, view_.distance * r, ratio / (r * r)};
    }

    const TubeView& view_;
    const Vec3& point_;
    const Visible& visible_;
    TubeShape shape_;
};

struct Sums {
    double all = 0, hidden = 0;

    Sums& operator+=(const Sums& other) {
        all += other.all, hidden += other.hidden;
        return *this;
    }
};

/// Over [middle - half, middle + half], halved until the two rules agree on the hidden share to
/// within `error`, an absolute one for the whole width, or to `depth`.
Sums integrate(const Width& width, double middle, double half, double error, int depth) {
    Sums fine, coarse;
    const auto add = [&](double x, std::size_t i) {
        const Width::Slice slice = width.at(middle + half * x);
        fine += {half * kronrod[i] * slice.all, half * kronrod[i] * slice.hidden};
        coarse += {half * gauss[i] * slice.all, half * gauss[i] * slice.hidden};
    };
    add(0, 0);
    for (std::size_t i = 1; i < nodes.size(); ++i) {
        add(nodes[i], i);
        add(-nodes[i], i);
    }
    const double off =
        coarse.all > 0 ? coarse.hidden * (fine.all / coarse.all) - fine.hidden : fine.hidden;
    if (depth == 0 || std::abs(off) <= error) return fine;
    Sums both = integrate(width, middle - half / 2, half / 2, error / 2, depth - 1);
    both += integrate(width, middle + half / 2, half / 2, error / 2, depth - 1);
    return both;
}

} // namespace

double visible_share(const TubeLamp& lamp, const Vec3& point, const Vec3& normal,
                     const Visible& visible, double tolerance, TubeShape shape) {
    const auto view = view_of(lamp, point, normal);
    // Along the axis the cap alone lights.
    if (!view) return visible.intervals({lamp.a, lamp.b}).empty() ? 0 : 1;
    const Width width(*view, point, visible, shape);
    constexpr int most_halvings = 14;
    const Sums sums = integrate(width, 0, 1, tolerance * width.scale(), most_halvings);
    return sums.all > 0 ? std::clamp(1 - sums.hidden / sums.all, 0.0, 1.0) : 1;
}

} // namespace keiko
