#include "keiko/light/penumbra/width_samples.h"

#include <algorithm>
#include <cmath>

namespace keiko {

namespace {

/// Nodes on [-1, 1].
constexpr std::array<double, Slices::count> nodes{
    -1, -0.9604912687080202, -0.7745966692414834, -0.4342437493468026,
    0,  0.4342437493468026,  0.7745966692414834,  0.9604912687080202,
    1};
constexpr double gauss_spacing = 0.7745966692414834; ///< the widest between nodes
constexpr double kronrod_spacing = 0.4342437493468026;
using Weights = std::array<double, Slices::count>;
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
constexpr std::array<std::size_t, 2> of_gauss_alone{2, 6};
constexpr std::array<std::size_t, 4> of_kronrod_alone{1, 3, 5, 7};

/// Computes the light of the slices of some nodes.
void light_slices(const SourceWidth& width, std::span<const std::size_t> nodes_of, Slices& slices) {
    for (const std::size_t i : nodes_of) {
        slices.axes[i] = width.sub_axis(slices.center + slices.half * nodes[i]);
        slices.at[i] = {width.lit(slices.axes[i], 0, 1)};
    }
}

/// A part of the width before any query.
Slices part_of(const SourceWidth& width, double center, double half, bool tapers) {
    constexpr double negligible = 1e-6; // of the middle's light
    Slices part{center, half};
    light_slices(width, of_gauss, part);
    for (const std::size_t end : Slices::ends)
        if (tapers && part.at[end].all < negligible * part.at[Slices::middle].all)
            part.at[end].all = 0;
    return part;
}

SolidAngle weighed(const Slices& slices, const Weights& weights) {
    SolidAngle sums;
    for (std::size_t i = 0; i < Slices::count; ++i) {
        const double weight = slices.half * weights[i] * slices.axes[i].weight;
        sums += {weight * slices.at[i].all, weight * slices.at[i].hidden};
    }
    return sums;
}

/// Difference of two rules in the hidden part.
double difference(const SolidAngle& coarse, const SolidAngle& fine) {
    return std::abs(coarse.all > 0 ? coarse.hidden * (fine.all / coarse.all) - fine.hidden
                                   : fine.hidden);
}

/// Error that may be missed between an end and the node next to it. It is the deviation of the
/// end's hidden share from the line through that node and one farther in, for the share of the
/// width in between.
double missed_at(const Slices& slices, std::size_t end, std::size_t node, std::size_t inner) {
    const auto &e = slices.at[end], &n = slices.at[node], &i = slices.at[inner];
    if (!(e.all > 0 && n.all > 0 && i.all > 0)) return 0;
    const double beyond = (nodes[end] - nodes[node]) / (nodes[node] - nodes[inner]);
    const double off = e.share() - n.share() - (n.share() - i.share()) * beyond;
    return std::abs(off) * std::abs(nodes[end] - nodes[node]) / 2;
}

/// Error bound of the middle. It is the deviation of its hidden share, or of the ends of its
/// visible parts, from the lines through those of the ends. It includes what may be missed if the
/// middle is on the line by chance, as in the middle of a ramp between two kinks.
double missed_by_middle(const Slices& slices) {
    const double begin = slices.at[0].share(), end = slices.at[8].share();
    constexpr double by_chance = 0.1;
    return std::max({std::abs(slices.at[4].share() - (begin + end) / 2),
                     by_chance * std::abs(end - begin), slices.parts_off});
}

/// Beyond the last node towards an end without light the share may change as much as before it.
double missed_by_gauss(const Slices& slices) {
    const auto missed = [&](std::size_t end, std::size_t node) {
        if (slices.at[end].all > 0) return missed_at(slices, end, node, Slices::middle);
        const double change = slices.at[node].share() - slices.at[Slices::middle].share();
        return std::abs(change) * std::abs(nodes[end] - nodes[node]) / 2;
    };
    return missed(Slices::first, 2) + missed(Slices::last, 6);
}

double missed_by_kronrod(const Slices& slices) {
    return missed_at(slices, 0, 1, 2) + missed_at(slices, 8, 7, 6);
}

/// True if nodes with a `spacing` between them on [-1, 1] are at most the widest spacing apart.
bool near_enough(const Slices& slices, double spacing, double widest) {
    return spacing * slices.half <= widest;
}

/// True if the slices between the ends light anything, and, unless the source tapers, the ends.
bool all_above(const Slices& slices, bool tapers) {
    const auto lit = [&](std::size_t i) { return slices.at[i].all > 0; };
    return std::all_of(of_gauss.begin() + 1, of_gauss.end() - 1, lit) &&
           (tapers || std::all_of(Slices::ends.begin(), Slices::ends.end(), lit));
}

/// Integral over parts of a width, by the first of three rules that is accurate enough, else by
/// halves.
class WidthIntegral {
public:
    WidthIntegral(const SourceWidth& width, const Visibility& visible, const SliceRule& until)
        : width_(width),
          visible_(visible),
          widest_spacing_(until.widest_spacing),
          part_by_part_(until.part_by_part),
          tapers_(until.tapers) {}

    SolidAngle over(Slices slices, double error, int most_halvings) const {
        if (!near_enough(slices, kronrod_spacing, widest_spacing_))
            return in_halves(slices, error, most_halvings);
        if (ends_and_middle_agree(slices, {error, widest_spacing_, part_by_part_})) {
            const double all = weighed(slices, gauss).all;
            return {all, all * slices.at[Slices::middle].share()};
        }
        find(of_gauss_alone, slices);
        const SolidAngle three = weighed(slices, gauss);
        if (all_above(slices, tapers_) && near_enough(slices, gauss_spacing, widest_spacing_) &&
            difference(weighed(slices, middle_alone), three) <= error &&
            missed_by_gauss(slices) * three.all <= error)
            return three;
        light_slices(width_, of_kronrod_alone, slices);
        find(of_kronrod_alone, slices);
        const SolidAngle seven = weighed(slices, kronrod);
        const bool agree =
            difference(three, seven) <= error && missed_by_kronrod(slices) * seven.all <= error;
        return agree || most_halvings == 0 ? seven : in_halves(slices, error, most_halvings);
    }

private:
    void find(std::span<const std::size_t> nodes_of, Slices& slices) const {
        std::vector<Segment> lines;
        for (const std::size_t i : nodes_of)
            if (slices.at[i].all > 0) lines.push_back(width_.line_of(slices.axes[i]));
        const std::vector<IntervalSet> seen = visible_.intervals(lines);
        auto next = seen.begin();
        for (const std::size_t i : nodes_of)
            if (slices.at[i].all > 0) hide_slice(width_, i, *next++, slices);
    }
    /// Halves of a part; their ends are known from the whole.
    std::array<Slices, 2> halves_of(const Slices& whole) const {
        const double half = whole.half / 2;
        std::array halves{part_of(width_, whole.center - half, half, tapers_),
                          part_of(width_, whole.center + half, half, tapers_)};
        halves[0].seen = {whole.seen[0], {}, whole.seen[1]};
        halves[1].seen = {whole.seen[1], {}, whole.seen[2]};
        return halves;
    }
    SolidAngle in_halves(const Slices& slices, double error, int most_halvings) const {
        std::array<Slices, 2> halves = halves_of(slices);
        std::vector<Segment> lines;
        add_ends_and_middles(width_, halves, lines);
        const std::vector<IntervalSet> seen = visible_.intervals(lines);
        auto next = seen.begin();
        hide_ends_and_middles(width_, part_by_part_, halves, next);
        SolidAngle both;
        for (Slices& half : halves) both += over(std::move(half), error / 2, most_halvings - 1);
        return both;
    }

    const SourceWidth& width_;
    const Visibility& visible_;
    double widest_spacing_;
    bool part_by_part_, tapers_;
};

} // namespace

double Slices::brightest() const {
    double most = 0;
    for (const std::size_t i : of_gauss) most = std::max(most, axes[i].weight * at[i].all);
    return most;
}

std::vector<Slices> parts_of(const SourceWidth& width, std::span<const WidthCut> cuts,
                             bool tapers) {
    constexpr double beside = 2e-6;
    struct Border {
        double end, begin; ///< of the parts on both sides
    };
    std::vector<Border> borders;
    for (const double place : width.cuts()) borders.push_back({place, place});
    for (const WidthCut& cut : cuts)
        borders.push_back({cut.begin - beside, cut.jump ? cut.end + beside : cut.begin - beside});
    std::sort(borders.begin(), borders.end(),
              [](const Border& a, const Border& b) { return a.end < b.end; });
    std::vector<Slices> parts;
    double begin = -1, last_end = -1;
    for (const Border& border : borders) {
        const double end = std::min(border.end, 1.0);
        if (begin < end) {
            parts.push_back(part_of(width, (end + begin) / 2, (end - begin) / 2, tapers));
            const std::size_t count = parts.size();
            parts.back().begins_where_last_ends =
                count > 1 && begin == last_end && parts[count - 2].at[Slices::last].all > 0;
            last_end = end;
        }
        begin = std::max(begin, border.begin);
    }
    return parts;
}

void hide_slice(const SourceWidth& width, std::size_t node, const IntervalSet& seen,
                Slices& slices) {
    for (const ParameterInterval& dark : seen.complement())
        slices.at[node].hidden += width.lit(slices.axes[node], dark.begin, dark.end);
}

bool ends_and_middle_agree(const Slices& slices, const SliceRule& until) {
    return all_above(slices, false) && near_enough(slices, 1, until.widest_spacing) &&
           missed_by_middle(slices) * weighed(slices, gauss).all <= until.error;
}

SolidAngle integrate(const SourceWidth& width, const Visibility& visible, Slices slices,
                     const SliceRule& until) {
    return WidthIntegral(width, visible, until)
        .over(std::move(slices), until.error, until.most_halvings);
}

namespace {

/// Begins and ends of the visible parts of a slice, in turn: shares of its light on one side.
std::vector<double> seen_ends(const SourceWidth& width, const SubAxis& axis, double all,
                              const IntervalSet& seen) {
    std::vector<double> ends;
    for (const ParameterInterval& part : seen)
        for (const double end : {part.begin, part.end})
            ends.push_back(width.lit(axis, 0, end) / all);
    return ends;
}

/// Deviation of the ends of the middle's visible parts from the lines through those of the ends; 1,
/// all of it, if these do not have as many parts.
double parts_off(const SourceWidth& width, const Slices& slices) {
    std::array<std::vector<double>, 3> ends;
    for (std::size_t k = 0; k < ends.size(); ++k) {
        const std::size_t node = Slices::ends_and_middle[k];
        ends[k] = seen_ends(width, slices.axes[node], slices.at[node].all, *slices.seen[k]);
        if (ends[k].size() != ends[0].size()) return 1;
    }
    double off = 0;
    for (std::size_t i = 0; i < ends[0].size(); ++i)
        off += std::abs(ends[1][i] - (ends[0][i] + ends[2][i]) / 2);
    return off;
}

/// True if the visibility of the line of an end or the middle must be queried.
bool is_asked(const Slices& slices, std::size_t k) {
    const bool shared = k == 0 && slices.begins_where_last_ends;
    return slices.at[Slices::ends_and_middle[k]].all > 0 && !slices.seen[k] && !shared;
}

} // namespace

void add_ends_and_middles(const SourceWidth& width, std::span<const Slices> parts,
                          std::vector<Segment>& lines) {
    for (const Slices& part : parts)
        for (std::size_t k = 0; k < part.seen.size(); ++k)
            if (is_asked(part, k))
                lines.push_back(width.line_of(part.axes[Slices::ends_and_middle[k]]));
}

void hide_ends_and_middles(const SourceWidth& width, bool part_by_part, std::span<Slices> parts,
                           std::vector<IntervalSet>::const_iterator& next) {
    const Slices* last = nullptr;
    for (Slices& part : parts) {
        bool all = true;
        for (std::size_t k = 0; k < part.seen.size(); ++k) {
            if (is_asked(part, k))
                part.seen[k] = *next++;
            else if (k == 0 && last && part.begins_where_last_ends)
                part.seen[k] = last->seen.back();
            if (part.seen[k]) hide_slice(width, Slices::ends_and_middle[k], *part.seen[k], part);
            all = all && part.seen[k];
        }
        if (part_by_part && all) part.parts_off = parts_off(width, part);
        last = &part;
    }
}

} // namespace keiko
