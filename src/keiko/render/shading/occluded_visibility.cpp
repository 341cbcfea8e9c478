#include "keiko/render/shading/occluded_visibility.h"

#include "keiko/base/job.h"

namespace keiko {
namespace {

std::vector<IntervalSet> seen_by(const VisibilityQuery& view, std::span<const Segment> segments) {
    std::vector<IntervalSet> seen;
    seen.reserve(segments.size());
    for (VisibleIntervals& parts : view.intervals(segments))
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
    if (!place) return view().intervals(segment).intervals;
    if (of_row_.empty()) of_row_ = pencil_ ? pencil_->intervals(row_) : seen_by(view(), row_);
    return of_row_[*place];
}

/// Searches on from the segment that was found last.
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
    return view().classify_prisms(prisms);
}

std::vector<CriticalSlice> OccludedVisibility::turns(const Prism& prism,
                                                     const TurnRule& rule) const {
    if (!occluders_) return {};
    return view().turns(prism, rule);
}

} // namespace keiko
