#include "keiko/tubes/tube_penumbra.h"

#include "keiko/tubes/tube_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace keiko {
namespace {

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

/// A slice of the lamp, and what of it is hidden.
struct Slice {
    double all = 0, hidden = 0;
};
/// At the nodes of a part of the width.
struct Slices {
    double middle = 0, half = 1;
    std::array<SubAxis, node_count> axes{};
    std::array<Slice, node_count> at{};
};

/// What some nodes' slices light, and the lines to be asked for: of those that light anything.
void prepare(const LampWidth& width, std::span<const std::size_t> nodes_of, Slices& slices,
             std::vector<Segment>& lines) {
    for (const std::size_t i : nodes_of) {
        slices.axes[i] = width.sub_axis(slices.middle + slices.half * nodes[i]);
        slices.at[i] = {width.lit(slices.axes[i], 0, 1)};
        if (slices.at[i].all > 0) lines.push_back(width.line_of(slices.axes[i]));
    }
}

/// With what is seen of those lines, from `next` on.
void finish(const LampWidth& width, std::span<const std::size_t> nodes_of, Slices& slices,
            std::vector<IntervalSet>::const_iterator& next) {
    for (const std::size_t i : nodes_of) {
        if (!(slices.at[i].all > 0)) continue;
        for (const ParameterInterval& dark : next++->complement())
            slices.at[i].hidden += width.lit(slices.axes[i], dark.begin, dark.end);
    }
}

/// What the middle slice lights of a lamp as wide as this one, or the brightest where the middle is
/// below the horizon or hidden: the scale of errors.
double scale_of(const LampWidth& width) {
    double most = width.lit(width.sub_axis(0), 0, 1);
    if (!(most > 0))
        for (const double x : nodes) most = std::max(most, width.lit(width.sub_axis(x), 0, 1));
    return 2 * most;
}

std::vector<Slices> parts_of(const LampWidth& width) {
    const std::vector<double> cuts = width.cuts();
    std::vector<Slices> parts;
    for (std::size_t i = 1; i < cuts.size(); ++i)
        if (cuts[i - 1] < cuts[i])
            parts.push_back({(cuts[i] + cuts[i - 1]) / 2, (cuts[i] - cuts[i - 1]) / 2});
    return parts;
}

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
Sums integrate(const LampWidth& width, const Visible& visible, Slices slices, double error,
               int depth) {
    const auto find = [&](std::span<const std::size_t> nodes_of, Slices& of) {
        std::vector<Segment> lines;
        prepare(width, nodes_of, of, lines);
        const std::vector<IntervalSet> seen = visible.intervals(lines);
        auto next = seen.begin();
        finish(width, nodes_of, of, next);
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
    LampWidth width;
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
            visible.seen_alike(LampWidth(*view, point, shape, others).outline())) {
            shares.push_back(visible.intervals({row[i].a, row[i].b}).empty() ? 0 : 1);
            continue;
        }
        const LampWidth width(*view, point, shape, others);
        parts.push_back({i, width, parts_of(width)});
        for (Slices& slices : parts.back().slices) prepare(width, of_gauss, slices, lines);
        shares.push_back(1);
    }
    const std::vector<IntervalSet> seen = visible.intervals(lines);
    auto next = seen.begin();
    for (PartlySeen& part : parts) {
        constexpr int most_halvings = 14;
        const double error = tolerance * scale_of(part.width);
        Sums sums;
        for (Slices& slices : part.slices) {
            finish(part.width, of_gauss, slices, next);
            sums += integrate(part.width, visible, slices, error * slices.half, most_halvings);
        }
        shares[part.lamp] = share_of(sums);
    }
    return shares;
}

} // namespace keiko
