#include "keiko/render/shading/occluded_visibility.h"

#include "keiko/base/job.h"

namespace keiko {
namespace {

SegmentEnds ends_of(const Segment& segment) {
    return {segment.a, segment.b};
}

std::vector<SegmentEnds> ends_of(std::span<const Segment> segments) {
    std::vector<SegmentEnds> ends;
    ends.reserve(segments.size());
    for (const Segment& segment : segments) ends.push_back(ends_of(segment));
    return ends;
}

PrismEdges ends_of(const Prism& prism) {
    return {ends_of(prism[0]), ends_of(prism[1]), ends_of(prism[2]), ends_of(prism[3])};
}

std::vector<IntervalSet> seen_by(const VisibilityQuery& view, std::span<const Segment> segments) {
    std::vector<IntervalSet> seen;
    seen.reserve(segments.size());
    for (VisibleIntervals& parts : view.intervals(ends_of(segments)))
        seen.push_back(std::move(parts.intervals));
    return seen;
}

} // namespace

const VisibilityQuery& OccludedVisibility::view() const {
    if (!view_) view_.emplace(*occluders_, tracer_, viewpoint_, region_, facing_);
    return *view_;
}

IntervalSet OccludedVisibility::intervals(const Segment& segment) const {
    check_stop();
    if (!occluders_) return IntervalSet::whole();
    const auto place = place_in_row(segment);
    if (!place) return view().intervals(segment.a, segment.b).intervals;
    if (of_row_.empty())
        of_row_ = pencil_ ? pencil_->intervals(ends_of(std::span(row_))) : seen_by(view(), row_);
    return of_row_[*place];
}

/// Looks on from the segment that was found last.
std::optional<std::size_t> OccludedVisibility::place_in_row(const Segment& segment) const {
    for (std::size_t i = 0; i < row_.size(); ++i) {
        const std::size_t place = (next_ + i) % row_.size();
        if (row_[place] != segment) continue;
        next_ = place + 1;
        return place;
    }
    return std::nullopt;
}

std::vector<IntervalSet> OccludedVisibility::intervals(std::span<const Segment> segments) const {
    if (!occluders_) return std::vector<IntervalSet>(segments.size(), IntervalSet::whole());
    return seen_by(view(), segments);
}

std::vector<std::optional<bool>> OccludedVisibility::classify_prisms(
    std::span<const Prism> prisms) const {
    if (!occluders_) return std::vector<std::optional<bool>>(prisms.size(), true);
    std::vector<PrismEdges> edges;
    edges.reserve(prisms.size());
    for (const Prism& prism : prisms) edges.push_back(ends_of(prism));
    return view().classify_prisms(edges);
}

std::vector<PrismTurn> OccludedVisibility::turns(const Prism& prism, const TurnRule& rule) const {
    std::vector<PrismTurn> turns;
    if (!occluders_) return turns;
    for (const CriticalSlice& turn : view().turns(ends_of(prism), rule.gap, rule.missed))
        turns.push_back({turn.way, turn.missed, turn.dark, turn.jump});
    return turns;
}

} // namespace keiko
