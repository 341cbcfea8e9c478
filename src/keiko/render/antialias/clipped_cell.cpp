#include "keiko/render/antialias/clipped_cell.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Of a cell's mean side: how near the line between its crossings an outline has to be.
constexpr double slack = 0.1;

/// What lies between two crossings, counted around the cell.
CutPart part_between(const SeenCell& seen, const EdgeCrossing& begin, const EdgeCrossing& end) {
    const auto corners = seen.cell.corners();
    // What shows at the far end of the first side's crossing is in the part, as is what shows at
    // the near end of the last one's.
    SampledPolygon part;
    const auto add = [&](const Vec2& corner, const PixelSample* sample) {
        part.corners.push_back(corner), part.seen.push_back(sample);
    };
    add(begin.middle(), begin.at_b);
    for (std::size_t i = begin.side; i != end.side; i = (i + 1) % 4)
        add(corners[(i + 1) % 4], seen.corners[(i + 1) % 4]);
    add(end.middle(), end.at_a);
    const Vec2 cut = (begin.middle() + end.middle()) / 2;
    const Vec2 step = part.whole().centre - cut;
    const double farthest = slack * std::sqrt(seen.cell.area()) / step.length();
    return {part, cut + step * std::min(farthest, 1.0)};
}

} // namespace

ClippedCell::ClippedCell(const SeenCell& cell, const EdgeCrossing& first,
                         const EdgeCrossing& second)
    : seen(cell), parts{part_between(cell, first, second), part_between(cell, second, first)} {}

bool ClippedCell::holds_centre() const {
    if (!seen.cell.centre) return true;
    const Vec2 centre = seen.cell.corner + seen.cell.size / 2;
    const auto off = [&](const CutPart& part) { return (part.beside_cut - centre).length2(); };
    return parts[off(parts[0]) < off(parts[1]) ? 0 : 1].seen.shows(*seen.cell.centre);
}

} // namespace keiko
