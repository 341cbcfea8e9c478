// Segments on rays from one eye: their planes through the apex all hold the axis from the apex to
// the eye, so that they are scan lines of the screen whose lines run along that axis.
#include "keiko/trace/apex_candidates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace keiko {

const ApexView::Candidates::Pencil* ApexView::Candidates::pencil() const {
    if (pencil_ || !eye_ || apex_.infinite()) return pencil_ ? &*pencil_ : nullptr;
    const Screen& screen = screen_of((*eye_ - apex_.place()).normalized());
    if (!screen.screen.regular()) return nullptr;
    constexpr double widest = 8;
    double low = widest, high = -widest;
    for (const Vec3& corner : region_) {
        const ScreenPlace place = screen.screen.place(corner);
        const bool before = place.depth > 0;
        low = before ? std::min(low, place.across) : -widest;
        high = before ? std::max(high, place.across) : widest;
    }
    std::vector<ScreenBox> boxes = screen.pieces;
    boxes.insert(boxes.end(), screen.borders.begin(), screen.borders.end());
    pencil_.emplace(Pencil{screen.screen, ScanBuckets(std::move(boxes), low, high)});
    return &*pencil_;
}

bool ApexView::Candidates::add_events_of_pencil(const SegmentEnds& ends, Line& line) const {
    const Pencil* pencil = this->pencil();
    if (!pencil) return false;
    // rad: less than the boxes have room for.
    constexpr double in_plane = 1e-10;
    if (!(std::abs(line.plane.normal().dot(pencil->screen.along())) <= in_plane)) return false;
    ScreenPlace near = pencil->screen.place(ends[0]), far = pencil->screen.place(ends[1]);
    if (near.depth > far.depth) std::swap(near, far);
    // The eye itself lies on the axis, where every line ends.
    constexpr double on_axis = 1e-9, infinity = std::numeric_limits<double>::infinity();
    const bool from_eye = near.depth <= on_axis * far.depth;
    if (!(far.depth > 0 && near.depth >= -on_axis * far.depth)) return false;
    const double low = from_eye ? -infinity : std::min(near.along, far.along);
    const double high = from_eye ? infinity : std::max(near.along, far.along);
    const std::size_t pieces = silhouettes_.pieces.size();
    pencil->boxes.each_met(far.across, low, high, [&](std::size_t i) {
        i < pieces ? add_piece_events(i, line) : add_border_events(i - pieces, line);
    });
    return true;
}

std::vector<SeenParts> ApexView::Candidates::intervals_of_bundle(
    std::span<const SegmentEnds> row) const {
    std::vector<std::optional<Line>> lines;
    for (const SegmentEnds& ends : row) {
        lines.push_back(ends[0] == ends[1] ? std::nullopt : line_through(ends));
        if (lines.back()) add_events(ends, *lines.back());
    }
    GapGroups groups;
    std::vector<std::size_t> first_gap;
    for (std::optional<Line>& line : lines) {
        first_gap.push_back(groups.size());
        if (line) groups.add(line->plane, gaps_between(line->events, line->asked));
    }
    first_gap.push_back(groups.size());
    groups.classify(*tracer_);
    std::vector<SeenParts> parts;
    for (std::size_t i = 0; i < row.size(); ++i) {
        const std::size_t first = first_gap[i], count = first_gap[i + 1] - first;
        parts.push_back(lines[i] ? SeenParts{groups.seen(first, count), lines[i]->certain}
                                 : intervals(row[i]));
    }
    return parts;
}

} // namespace keiko
