#include "keiko/tubes/tube_penumbra.h"

#include "keiko/math/perpendicular.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keiko {
namespace {

/// Nodes of Gauss's rules of 1 and 3 and of Kronrod's of 7, each of which holds those before it, on
/// [-1, 1]; and both ends, which weigh nothing, but tell what lies beyond the last node.
constexpr std::size_t node_count = 9;
constexpr std::array<double, node_count> nodes{
    -1, -0.9604912687080202, -0.7745966692414834, -0.4342437493468026,
    0,  0.4342437493468026,  0.7745966692414834,  0.9604912687080202,
    1};
using Weights = std::array<double, node_count>;
constexpr Weights kronrod{0,
                          0.1046562260264673,
                          0.2684880898683334,
                          0.4013974147759622,
                          0.4509165386584741,
                          0.4013974147759622,
                          0.2684880898683334,
                          0.1046562260264673,
                          0};
constexpr Weights gauss{0, 0, 0.5555555555555556, 0, 0.8888888888888889, 0, 0.5555555555555556,
                        0, 0};
constexpr Weights middle_alone{0, 0, 0, 0, 2, 0, 0, 0, 0};
constexpr std::array<std::size_t, 5> of_gauss{0, 2, 4, 6, 8}; ///< with the ends
constexpr std::array<std::size_t, 3> ends_and_middle{0, 4, 8};
constexpr std::array<std::size_t, 2> of_gauss_alone{2, 6};
constexpr std::array<std::size_t, 4> of_kronrod_alone{1, 3, 5, 7};

/// Solid angle of a slice of the lamp, by its wedge angle, and what of it is hidden.
struct Slice {
    double all = 0, hidden = 0;

    double share() const { return hidden / all; }
};
/// At the nodes of a part of the width.
struct Slices {
    double middle = 0, half = 1;
    std::array<SubAxis, node_count> axes{};
    std::array<Slice, node_count> at{};
};

/// What some nodes' slices light.
void light_slices(const LampWidth& width, std::span<const std::size_t> nodes_of, Slices& slices) {
    for (const std::size_t i : nodes_of) {
        slices.axes[i] = width.sub_axis(slices.middle + slices.half * nodes[i]);
        slices.at[i] = {width.lit(slices.axes[i], 0, 1)};
    }
}

/// The lines to be asked for: of slices that light anything.
void add_lines(const LampWidth& width, std::span<const std::size_t> nodes_of, const Slices& slices,
               std::vector<Segment>& lines) {
    for (const std::size_t i : nodes_of)
        if (slices.at[i].all > 0) lines.push_back(width.line_of(slices.axes[i]));
}

/// With what is seen of those lines, from `next` on.
void hide_slices(const LampWidth& width, std::span<const std::size_t> nodes_of, Slices& slices,
                 std::vector<IntervalSet>::const_iterator& next) {
    for (const std::size_t i : nodes_of) {
        if (!(slices.at[i].all > 0)) continue;
        for (const ParameterInterval& dark : next++->complement())
            slices.at[i].hidden += width.lit(slices.axes[i], dark.begin, dark.end);
    }
}

/// A part of the width, of which nothing is asked yet.
Slices part_of(const LampWidth& width, double middle, double half) {
    Slices part{middle, half};
    light_slices(width, of_gauss, part);
    return part;
}

std::vector<Slices> parts_of(const LampWidth& width) {
    const std::vector<double> cuts = width.cuts();
    std::vector<Slices> parts;
    for (std::size_t i = 1; i < cuts.size(); ++i)
        if (cuts[i - 1] < cuts[i])
            parts.push_back(
                part_of(width, (cuts[i] + cuts[i - 1]) / 2, (cuts[i] - cuts[i - 1]) / 2));
    return parts;
}

struct Sums {
    double all = 0, hidden = 0;

    Sums& operator+=(const Sums& other) {
        all += other.all, hidden += other.hidden;
        return *this;
    }
    double visible_share() const { return all > 0 ? std::clamp(1 - hidden / all, 0.0, 1.0) : 1; }
};

Sums weighed(const Slices& slices, const Weights& weights) {
    Sums sums;
    for (std::size_t i = 0; i < node_count; ++i) {
        const double weight = slices.half * weights[i] * slices.axes[i].weight;
        sums += {weight * slices.at[i].all, weight * slices.at[i].hidden};
    }
    return sums;
}

/// By how much two rules disagree on what is hidden.
double difference(const Sums& coarse, const Sums& fine) {
    return std::abs(coarse.all > 0 ? coarse.hidden * (fine.all / coarse.all) - fine.hidden
                                   : fine.hidden);
}

/// What may be missed between an end and the node next to it: by how much the end's hidden share is
/// off the line through that node and one farther in, for the share of the width in between.
double missed_at(const Slices& slices, std::size_t end, std::size_t node, std::size_t inner) {
    const auto &e = slices.at[end], &n = slices.at[node], &i = slices.at[inner];
    if (!(e.all > 0 && n.all > 0 && i.all > 0)) return 0;
    const double beyond = (nodes[end] - nodes[node]) / (nodes[node] - nodes[inner]);
    const double off = e.share() - n.share() - (n.share() - i.share()) * beyond;
    return std::abs(off) * std::abs(nodes[end] - nodes[node]) / 2;
}

/// By how much the middle's hidden share is off the line through those of the ends, and what may
/// be missed where it is on the line by chance, as in the middle of a ramp between two kinks.
double missed_by_middle(const Slices& slices) {
    const double begin = slices.at[0].share(), end = slices.at[8].share();
    constexpr double by_chance = 0.1;
    return std::max(std::abs(slices.at[4].share() - (begin + end) / 2),
                    by_chance * std::abs(end - begin));
}

double missed_by_gauss(const Slices& slices) {
    return missed_at(slices, 0, 2, 4) + missed_at(slices, 8, 6, 4);
}

double missed_by_kronrod(const Slices& slices) {
    return missed_at(slices, 0, 1, 2) + missed_at(slices, 8, 7, 6);
}

/// Over what `slices` stand for, whose ends and middle are known: by more nodes, then by halves,
/// until two rules agree on what is hidden to within `error`, an absolute one for this part, and
/// the ends with the nodes next to them, or to `depth`.
Sums integrate(const LampWidth& width, const Visible& visible, Slices slices, double error,
               int depth) {
    const auto find = [&](std::span<const std::size_t> nodes_of, Slices& of) {
        std::vector<Segment> lines;
        add_lines(width, nodes_of, of, lines);
        const std::vector<IntervalSet> seen = visible.intervals(lines);
        auto next = seen.begin();
        hide_slices(width, nodes_of, of, next);
    };
    const double all = weighed(slices, gauss).all;
    const bool above = std::all_of(of_gauss.begin(), of_gauss.end(),
                                   [&](std::size_t i) { return slices.at[i].all > 0; });
    if (above && missed_by_middle(slices) * all <= error) return {all, all * slices.at[4].share()};
    find(of_gauss_alone, slices);
    const Sums three = weighed(slices, gauss);
    if (above && difference(weighed(slices, middle_alone), three) <= error &&
        missed_by_gauss(slices) * three.all <= error)
        return three;
    light_slices(width, of_kronrod_alone, slices);
    find(of_kronrod_alone, slices);
    const Sums seven = weighed(slices, kronrod);
    if (depth == 0 ||
        (difference(three, seven) <= error && missed_by_kronrod(slices) * seven.all <= error))
        return seven;
    Sums both;
    for (const double side : {-0.5, 0.5}) {
        Slices part = part_of(width, slices.middle + side * slices.half, slices.half / 2);
        find(ends_and_middle, part);
        both += integrate(width, visible, part, error / 2, depth - 1);
    }
    return both;
}

/// A box around a tube.
Prism box_around(const TubeLamp& lamp) {
    const Vec3 along = (lamp.b - lamp.a).normalized();
    const Vec3 across = any_perpendicular(along) * (lamp.diameter / 2), up = along.cross(across);
    const auto moved = [&](const Vec3& by) { return Segment{lamp.a + by, lamp.b + by}; };
    return {moved(up - across), moved(-up - across), moved(across + up), moved(across - up)};
}

std::vector<Prism> boxes_around(std::span<const TubeLamp> row) {
    std::vector<Prism> boxes;
    for (const TubeLamp& lamp : row) boxes.push_back(box_around(lamp));
    return boxes;
}

/// Of a lamp's axis.
IntervalSet above_horizon(const TubeLamp& lamp, const Vec3& point, const Vec3& normal) {
    const double a = normal.dot(lamp.a - point), b = normal.dot(lamp.b - point);
    if (a >= 0 && b >= 0) return IntervalSet::whole();
    if (!(a > 0) && !(b > 0)) return {};
    return a > 0 ? IntervalSet::whole(0, a / (a - b)) : IntervalSet::whole(a / (a - b), 1);
}

/// A lamp of which some may be hidden, with the nodes that are asked for first.
struct PartlySeen {
    std::size_t lamp;
    LampWidth width;
    std::vector<Slices> slices;

    double share(const Visible& visible, double tolerance,
                 std::vector<IntervalSet>::const_iterator& next) {
        double brightest = 0;
        for (Slices& part : slices) {
            hide_slices(width, ends_and_middle, part, next);
            for (const std::size_t i : of_gauss)
                brightest = std::max(brightest, part.axes[i].weight * part.at[i].all);
        }
        constexpr int most_halvings = 14;
        Sums sums;
        for (const Slices& part : slices)
            sums += integrate(width, visible, part, tolerance * 2 * brightest * part.half,
                              most_halvings);
        return sums.visible_share();
    }
};

} // namespace

std::vector<SeenLight> seen_tubes(std::span<const TubeLamp> row, const Vec3& point,
                                  const Vec3& normal, const Visible& visible,
                                  const PenumbraOptions& options,
                                  std::span<const std::vector<HidingTube>> hiding) {
    const std::vector<std::optional<bool>> wholes = visible.seen_as_whole(boxes_around(row));
    std::vector<SeenLight> seen(row.size(), SeenLight{{}, 0});
    std::vector<PartlySeen> parts;
    std::vector<std::size_t> asked; ///< of whose axes
    std::vector<Segment> lines;
    for (std::size_t i = 0; i < row.size(); ++i) {
        if (wholes[i]) {
            if (*wholes[i]) seen[i] = {above_horizon(row[i], point, normal), 1};
            continue;
        }
        // Along the axis the cap alone lights.
        const auto view = view_of(row[i], point, normal);
        if (options.axes || !view) {
            asked.push_back(i);
            lines.push_back({row[i].a, row[i].b});
        }
        if (!view) continue;
        const std::span<const HidingTube> others =
            hiding.empty() ? std::span<const HidingTube>() : hiding[i];
        const LampWidth width(*view, point, options.shape, others);
        parts.push_back({i, width, parts_of(width)});
    }
    for (const PartlySeen& part : parts)
        for (const Slices& slices : part.slices)
            add_lines(part.width, ends_and_middle, slices, lines);
    const std::vector<IntervalSet> of_lines = visible.intervals(lines);
    auto next = of_lines.begin();
    for (const std::size_t lamp : asked) {
        seen[lamp].axis = *next++;
        seen[lamp].share = seen[lamp].axis.empty() ? 0 : 1;
    }
    for (PartlySeen& part : parts)
        seen[part.lamp].share = part.share(visible, options.tolerance, next);
    return seen;
}

} // namespace keiko
