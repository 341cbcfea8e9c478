#include "keiko/tubes/tube_penumbra.h"

#include "keiko/tubes/arc_integral.h"
#include "keiko/tubes/tube_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

// Key: as in cylinder_irradiance.cpp. A sub-axis is the line that the half-plane at the wedge angle
// psi cuts out of the lamp, at the distance r from the point.

namespace keiko {
namespace {

constexpr double pi = std::numbers::pi;

/// Nodes of Gauss's rules of 1 and 3 and of Kronrod's of 7, each of which holds those before it, on
/// [-1, 1].
constexpr std::size_t node_count = 7;
constexpr std::array<double, node_count> nodes{
    -0.9604912687080202, -0.7745966692414834, -0.4342437493468026, 0,
    0.4342437493468026,  0.7745966692414834,  0.9604912687080202};
using Weights = std::array<double, node_count>;
constexpr Weights kronrod{0.1046562260264673, 0.2684880898683334, 0.4013974147759622,
                          0.4509165386584741, 0.4013974147759622, 0.2684880898683334,
                          0.1046562260264673};
constexpr Weights gauss{0, 0.5555555555555556, 0, 0.8888888888888889, 0, 0.5555555555555556, 0};
constexpr Weights middle_alone{0, 0, 0, 2, 0, 0, 0};
constexpr std::array<std::size_t, 3> of_gauss{1, 3, 5};
constexpr std::array<std::size_t, 4> of_kronrod_alone{0, 2, 4, 6};

/// A sub-axis and what it weighs.
struct SubAxis {
    double cosine = 1, sine = 0; ///< of psi
    double r = 0;                ///< mm
    double weight = 0;           ///< d psi by the variable of integration
};

/// A slice of the lamp, and what of it is hidden.
struct Slice {
    double all = 0, hidden = 0;
};
/// At the nodes of a part of the width, which is [-1, 1].
struct Slices {
    double middle = 0, half = 1;
    std::array<SubAxis, node_count> axes{};
    std::array<Slice, node_count> at{};
};

class Width {
public:
    Width(const TubeView& view, const Vec3& point, TubeShape shape,
          std::span<const HidingTube> hiding)
        : view_(view), point_(point), shape_(shape), hiding_(hiding) {}

    /// What some nodes' slices light, and the lines to be asked for: of those that light anything.
    void prepare(std::span<const std::size_t> nodes_of, Slices& slices,
                 std::vector<Segment>& lines) const {
        for (const std::size_t i : nodes_of) {
            slices.axes[i] = sub_axis(slices.middle + slices.half * nodes[i]);
            slices.at[i] = {lit(slices.axes[i], 0, 1)};
            if (slices.at[i].all > 0) lines.push_back(line_of(slices.axes[i]));
        }
    }
    /// With what is seen of those lines, from `next` on.
    void finish(std::span<const std::size_t> nodes_of, Slices& slices,
                std::vector<IntervalSet>::const_iterator& next) const {
        for (const std::size_t i : nodes_of) {
            if (!(slices.at[i].all > 0)) continue;
            for (const ParameterInterval& dark : next++->complement())
                slices.at[i].hidden += lit(slices.axes[i], dark.begin, dark.end);
        }
    }
    /// What the middle slice lights of a lamp as wide as this one, or the brightest where the
    /// middle is below the horizon: the scale of errors.
    double scale() const {
        double most = lit(sub_axis(0), 0, 1);
        if (!(most > 0))
            for (const double x : nodes) most = std::max(most, lit(sub_axis(x), 0, 1));
        return 2 * most;
    }
    /// The whole width, cut where a neighbour begins or ends to hide some of it.
    std::vector<Slices> parts() const {
        std::vector<double> cuts{-1, 1};
        for (const HidingTube& tube : hiding_) {
            const double half = std::asin(view_.radius / tube.distance);
            for (const double psi : {tube.angle - half, tube.angle + half})
                if (const double x = place_of(psi); std::abs(x) < 1) cuts.push_back(x);
        }
        std::sort(cuts.begin(), cuts.end());
        std::vector<Slices> parts;
        for (std::size_t i = 1; i < cuts.size(); ++i)
            if (cuts[i - 1] < cuts[i])
                parts.push_back({(cuts[i] + cuts[i - 1]) / 2, (cuts[i] - cuts[i - 1]) / 2});
        return parts;
    }
    /// Both edges, and what is nearest.
    std::array<Segment, 3> outline() const {
        return {line_of(sub_axis(-1)), line_of(sub_axis(0)), line_of(sub_axis(1))};
    }

private:
    SubAxis sub_axis(double x) const {
        return shape_ == TubeShape::cylinder ? on_tube(x) : on_rectangle(x);
    }
    /// Where across the lamp a wedge angle is, beyond [-1, 1] beside it.
    double place_of(double psi) const {
        const double ratio = view_.radius / view_.distance;
        if (shape_ == TubeShape::rectangle) return std::tan(psi) / ratio;
        const double sine = std::sin(psi) / ratio;
        return std::abs(sine) < 1 ? std::asin(sine) / (pi / 2) : std::copysign(2, sine);
    }
    Segment line_of(const SubAxis& axis) const {
        const Vec3 foot =
            point_ + (view_.sideways * axis.sine - view_.towards * axis.cosine) * axis.r;
        return {foot + view_.along * view_.x_at(0), foot + view_.along * view_.x_at(1)};
    }
    double lit(const SubAxis& axis, double begin, double end) const {
        const double al = view_.n_lamp * axis.cosine + view_.n_sideways * axis.sine;
        const double low = std::atan2(view_.x_at(begin), axis.r);
        const double high = std::atan2(view_.x_at(end), axis.r);
        if (hiding_.empty()) return axis.weight * arc_integral(al, view_.n_along, low, high);
        const double psi = std::atan2(axis.sine, axis.cosine);
        double sum = 0;
        for (const ParameterInterval& open :
             IntervalSet(hidden_elevations(view_, hiding_, psi, axis.r)).complement(low, high))
            sum += arc_integral(al, view_.n_along, open.begin, open.end);
        return axis.weight * sum;
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

    TubeView view_;
    Vec3 point_;
    TubeShape shape_;
    std::span<const HidingTube> hiding_;
};

struct Sums {
    double all = 0, hidden = 0;

    Sums& operator+=(const Sums& other) {
        all += other.all, hidden += other.hidden;
        return *this;
    }
};

Sums weighed(const Slices& slices, const Weights& weights) {
    Sums sums;
    for (std::size_t i = 0; i < node_count; ++i)
        sums += {slices.half * weights[i] * slices.at[i].all,
                 slices.half * weights[i] * slices.at[i].hidden};
    return sums;
}

/// By how much two rules disagree on what is hidden.
double difference(const Sums& coarse, const Sums& fine) {
    return std::abs(coarse.all > 0 ? coarse.hidden * (fine.all / coarse.all) - fine.hidden
                                   : fine.hidden);
}

/// Over what `slices` stand for, whose Gaussian nodes are known: by more nodes, then by halves,
/// until two rules agree on the hidden share to within `error`, an absolute one for the whole
/// width, or to `depth`.
Sums integrate(const Width& width, const Visible& visible, Slices slices, double error, int depth) {
    const auto find = [&](std::span<const std::size_t> nodes_of, Slices& of) {
        std::vector<Segment> lines;
        width.prepare(nodes_of, of, lines);
        const std::vector<IntervalSet> seen = visible.intervals(lines);
        auto next = seen.begin();
        width.finish(nodes_of, of, next);
    };
    const Sums three = weighed(slices, gauss);
    const bool above = std::all_of(of_gauss.begin(), of_gauss.end(),
                                   [&](std::size_t i) { return slices.at[i].all > 0; });
    if (above && difference(weighed(slices, middle_alone), three) <= error) return three;
    find(of_kronrod_alone, slices);
    const Sums seven = weighed(slices, kronrod);
    if (depth == 0 || difference(three, seven) <= error) return seven;
    Sums both;
    for (const double side : {-0.5, 0.5}) {
        Slices part{slices.middle + side * slices.half, slices.half / 2};
        find(of_gauss, part);
        both += integrate(width, visible, std::move(part), error / 2, depth - 1);
    }
    return both;
}

/// Corner lines of a box around all tubes between the first and the last.
std::array<Segment, 4> corner_lines(std::span<const TubeLamp> row) {
    const TubeLamp &first = row.front(), &last = row.back();
    const Vec3 along = (first.b - first.a).normalized();
    Vec3 across = last.a - first.a;
    across -= along * along.dot(across);
    if (!(across.length2() > 0)) across = along.cross(Vec3(along.y, along.z, -along.x));
    across = across.normalized() * (first.diameter / 2);
    const Vec3 up = along.cross(across);
    const auto moved = [](const TubeLamp& lamp, const Vec3& by) {
        return Segment{lamp.a + by, lamp.b + by};
    };
    return {moved(first, up - across), moved(first, -up - across), moved(last, across + up),
            moved(last, across - up)};
}

/// A lamp of which some may be hidden.
struct PartlySeen {
    std::size_t lamp;
    Width width;
    std::vector<Slices> slices;
};

double share_of(const Sums& sums) {
    return sums.all > 0 ? std::clamp(1 - sums.hidden / sums.all, 0.0, 1.0) : 1;
}

} // namespace

std::vector<double> visible_shares(std::span<const TubeLamp> row, const Vec3& point,
                                   const Vec3& normal, const Visible& visible, double tolerance,
                                   TubeShape shape,
                                   std::span<const std::vector<HidingTube>> hiding) {
    if (row.empty()) return {};
    const bool all_alike = visible.seen_alike(corner_lines(row));
    std::vector<double> shares;
    std::vector<PartlySeen> parts;
    std::vector<Segment> lines;
    for (std::size_t i = 0; i < row.size(); ++i) {
        const std::span<const HidingTube> others =
            hiding.empty() ? std::span<const HidingTube>() : hiding[i];
        // Along the axis the cap alone lights.
        const auto view = view_of(row[i], point, normal);
        if (all_alike || !view ||
            visible.seen_alike(Width(*view, point, shape, others).outline())) {
            shares.push_back(visible.intervals({row[i].a, row[i].b}).empty() ? 0 : 1);
            continue;
        }
        const Width width(*view, point, shape, others);
        parts.push_back({i, width, width.parts()});
        for (Slices& slices : parts.back().slices) width.prepare(of_gauss, slices, lines);
        shares.push_back(1);
    }
    const std::vector<IntervalSet> seen = visible.intervals(lines);
    auto next = seen.begin();
    for (PartlySeen& part : parts) {
        constexpr int most_halvings = 14;
        const double error = tolerance * part.width.scale();
        Sums sums;
        for (Slices& slices : part.slices) {
            part.width.finish(of_gauss, slices, next);
            sums += integrate(part.width, visible, slices, error * slices.half, most_halvings);
        }
        shares[part.lamp] = share_of(sums);
    }
    return shares;
}

} // namespace keiko
