#include "keiko/render/shadows.h"

#include "keiko/render/source_region.h"

#include <algorithm>

namespace keiko {
namespace {

std::vector<SegmentEnds> ends_of(std::span<const Segment> segments) {
    std::vector<SegmentEnds> ends;
    ends.reserve(segments.size());
    for (const Segment& segment : segments) ends.push_back({segment.a, segment.b});
    return ends;
}

std::vector<IntervalSet> seen_by(const ApexView& view, std::span<const Segment> segments) {
    std::vector<IntervalSet> seen;
    seen.reserve(segments.size());
    for (SeenParts& parts : view.intervals(ends_of(segments)))
        seen.push_back(std::move(parts.intervals));
    return seen;
}

} // namespace

const ApexView& SeenPast::view() const {
    if (!view_) view_.emplace(*occluders_, tracer_, apex_, region_, facing_, eye_);
    return *view_;
}

IntervalSet SeenPast::intervals(const Segment& segment) const {
    if (!occluders_) return IntervalSet::whole();
    const auto place = place_in_row(segment);
    if (!place) return view().intervals(segment.a, segment.b).intervals;
    if (of_row_.empty()) of_row_ = seen_by(view(), row_);
    return of_row_[*place];
}

/// Looks on from the segment that was found last.
std::optional<std::size_t> SeenPast::place_in_row(const Segment& segment) const {
    for (std::size_t i = 0; i < row_.size(); ++i) {
        const std::size_t place = (next_ + i) % row_.size();
        if (row_[place] != segment) continue;
        next_ = place + 1;
        return place;
    }
    return std::nullopt;
}

std::vector<IntervalSet> SeenPast::intervals(std::span<const Segment> segments) const {
    if (!occluders_) return std::vector<IntervalSet>(segments.size(), IntervalSet::whole());
    return seen_by(view(), segments);
}

bool SeenPast::seen_alike(std::span<const Segment> segments) const {
    return !occluders_ || view().seen_alike(ends_of(segments));
}

LitPoint::LitPoint(const ShadowedRig& lights, const Vec3& point, const Vec3& normal,
                   const std::optional<Root>& root)
    : rig_(lights.rig_), point_(point), normal_(normal) {
    const Occluders* occluders = lights.occluders_;
    const Apex apex = Apex::at(point, root);
    seen_.reserve(rig_.sources.size());
    for (const LightSource& source : rig_.sources)
        if (occluders)
            seen_.emplace_back(occluders, lights.tracer_, apex, source_region(source, point),
                               source_segments(source), normal);
        else
            seen_.emplace_back(occluders, lights.tracer_, apex, std::vector<Vec3>());
}

Rgb LitPoint::from_source(std::size_t source, TubeModel model, const ClearCoat* coat) const {
    return illuminance_from(rig_.sources[source], rig_.medium, point_, normal_, seen_[source],
                            model, coat);
}

Rgb LitPoint::illuminance(TubeModel model, const ClearCoat* coat) const {
    Rgb sum;
    for (std::size_t i = 0; i < rig_.sources.size(); ++i) sum += from_source(i, model, coat);
    return sum;
}

} // namespace keiko
