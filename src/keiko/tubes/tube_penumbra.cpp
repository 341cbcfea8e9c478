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
constexpr std::size_t node_count = 7;
constexpr std::array<double, node_count> nodes{
    -0.9604912687080202, -0.7745966692414834, -0.4342437493468026, 0,
    0.4342437493468026,  0.7745966692414834,  0.9604912687080202};
constexpr std::array<double, node_count> kronrod{
    0.1046562260264673, 0.2684880898683334, 0.4013974147759622, 0.4509165386584741,
    0.4013974147759622, 0.2684880898683334, 0.1046562260264673};
constexpr std::array<double, node_count> gauss{0, 0.5555555555555556, 0, 0.8888888888888889,
                                               0, 0.5555555555555556, 0};

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

    /// A slice of the lamp, and what of it is hidden.
    struct Slice {
        double all = 0, hidden = 0;
    };
    /// At the nodes of [middle - half, middle + half] across the lamp, which is [-1, 1]: asked for
    /// together, as their lines are parallel.
    std::array<Slice, node_count> slices(double middle, double half) const {
        std::array<Slice, node_count> found;
        std::vector<Segment> lines;
        for (std::size_t i = 0; i < node_count; ++i) {
            const SubAxis axis = sub_axis(middle + half * nodes[i]);
            found[i].all = lit(axis, 0, 1);
            if (found[i].all > 0) lines.push_back(line_of(axis));
        }
        const std::vector<IntervalSet> seen = visible_.intervals(lines);
        auto of_line = seen.begin();
        for (std::size_t i = 0; i < node_count; ++i) {
            if (!(found[i].all > 0)) continue;
            const SubAxis axis = sub_axis(middle + half * nodes[i]);
            for (const ParameterInterval& dark : of_line++->complement())
                found[i].hidden += lit(axis, dark.begin, dark.end);
        }
        return found;
    }
    /// What the brightest slice lights of a lamp as wide as this one: the scale of errors. Of a
    /// lamp on the horizon the middle may give nothing.
    double scale() const {
        double most = 0;
        for (const double x : nodes) most = std::max(most, lit(sub_axis(x), 0, 1));
        return 2 * most;
    }

private:
    SubAxis sub_axis(double x) const {
        return shape_ == TubeShape::cylinder ? on_tube(x) : on_rectangle(x);
    }
    Segment line_of(const SubAxis& axis) const {
        const Vec3 foot =
            point_ + (view_.sideways * axis.sine - view_.towards * axis.cosine) * axis.r;
        return {foot + view_.along * view_.x_at(0), foot + view_.along * view_.x_at(1)};
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
    const std::array<Width::Slice, node_count> slices = width.slices(middle, half);
    for (std::size_t i = 0; i < node_count; ++i) {
        fine += {half * kronrod[i] * slices[i].all, half * kronrod[i] * slices[i].hidden};
        coarse += {half * gauss[i] * slices[i].all, half * gauss[i] * slices[i].hidden};
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
