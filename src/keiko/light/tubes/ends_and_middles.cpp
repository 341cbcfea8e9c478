#include "keiko/light/tubes/ends_and_middles.h"

#include <cmath>

namespace keiko {
namespace {

/// Where parts that are seen of a slice begin and end, in turn: shares of its light on one side.
std::vector<double> seen_ends(const LampWidth& width, const SubAxis& axis, double all,
                              const IntervalSet& seen) {
    std::vector<double> ends;
    for (const ParameterInterval& part : seen)
        for (const double end : {part.begin, part.end})
            ends.push_back(width.lit(axis, 0, end) / all);
    return ends;
}

/// By how much the ends of the middle's seen parts are off the lines through those of the ends; all
/// of it where these do not see as many parts.
double parts_off(const LampWidth& width, const Slices& slices) {
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

/// Whether it is to be asked what is seen of the line of an end or the middle.
bool is_asked(const Slices& slices, std::size_t k) {
    const bool shared = k == 0 && slices.begins_where_last_ends;
    return slices.at[Slices::ends_and_middle[k]].all > 0 && !slices.seen[k] && !shared;
}

} // namespace

void add_ends_and_middles(const LampWidth& width, std::span<const Slices> parts,
                          std::vector<Segment>& lines) {
    for (const Slices& part : parts)
        for (std::size_t k = 0; k < part.seen.size(); ++k)
            if (is_asked(part, k))
                lines.push_back(width.line_of(part.axes[Slices::ends_and_middle[k]]));
}

void hide_ends_and_middles(const LampWidth& width, bool part_by_part, std::span<Slices> parts,
                           std::vector<IntervalSet>::const_iterator& next) {
    const Slices* last = nullptr;
    for (Slices& part : parts) {
        bool all = true;
        for (std::size_t k = 0; k < part.seen.size(); ++k) {
            if (is_asked(part, k))
                part.seen[k] = *next++;
            else if (k == 0 && part.begins_where_last_ends)
                part.seen[k] = last->seen.back();
            if (part.seen[k]) hide_slice(width, Slices::ends_and_middle[k], *part.seen[k], part);
            all = all && part.seen[k];
        }
        if (part_by_part && all) part.parts_off = parts_off(width, part);
        last = &part;
    }
}

} // namespace keiko
