#include "keiko/render/cut_cell.h"

#include "keiko/render/outlines.h"

#include <algorithm>

namespace keiko {
namespace {

/// Of a cell's side: how near the line between its crossings an outline has to be.
constexpr double slack = 0.1;

/// What lies between two crossings, counted around the cell.
CutPart part_between(const SeenCell& seen, const CrossedSide& begin, const CrossedSide& end) {
    const auto corners = seen.cell.corners();
    // What shows at the far end of the first side's crossing is in the part, as is what shows at
    // the near end of the last one's.
    std::vector<Vec2> polygon{begin.middle()};
    std::vector<const EyeSample*> around{begin.at_b};
    for (std::size_t i = begin.side; i != end.side; i = (i + 1) % 4) {
        polygon.push_back(corners[(i + 1) % 4]);
        around.push_back(seen.corners[(i + 1) % 4]);
    }
    polygon.push_back(end.middle());
    around.push_back(end.at_a);
    std::vector<double> across;
    for (const EyeSample* sample : around) across.push_back(sample->across_lamps);
    const PicturePart part = polygon_part(polygon);
    const Vec2 cut = (begin.middle() + end.middle()) / 2, step = part.centre - cut;
    const double most = slack * seen.cell.side / step.length();
    return {part, around, polygon_mean(polygon, across), cut + step * std::min(most, 1.0)};
}

} // namespace

bool CutPart::shows(const EyeSample& sample) const {
    return std::any_of(around.begin(), around.end(),
                       [&](const EyeSample* corner) { return !differ(*corner, sample); });
}

bool CutPart::is_told_by(const EyeSample& amid, double size) const {
    return shows(amid) && !is_uneven(around, across, amid, size);
}

CutCell::CutCell(const SeenCell& cell, const CrossedSide& first, const CrossedSide& second)
    : seen(cell), parts{part_between(cell, first, second), part_between(cell, second, first)} {}

bool CutCell::holds_centre() const {
    if (!seen.cell.centre) return true;
    const Vec2 centre = seen.cell.corner + Vec2(seen.cell.side) / 2;
    const auto off = [&](const CutPart& part) { return (part.beside_cut - centre).length2(); };
    return parts[off(parts[0]) < off(parts[1]) ? 0 : 1].shows(*seen.cell.centre);
}

} // namespace keiko
