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
    if (!view_) view_.emplace(*occluders_, tracer_, apex_, region_, facing_);
    return *view_;
}

IntervalSet SeenPast::intervals(const Segment& segment) const {
    if (!occluders_) return IntervalSet::whole();
    const auto place = place_in_row(segment);
    if (!place) return view().intervals(segment.a, segment.b).intervals;
    if (of_row_.empty())
        of_row_ = pencil_ ? pencil_->intervals(ends_of(row_)) : seen_by(view(), row_);
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

std::vector<std::optional<bool>> SeenPast::seen_as_whole(std::span<const Prism> prisms) const {
    if (!occluders_) return std::vector<std::optional<bool>>(prisms.size(), true);
    std::vector<PrismEdges> edges;
    edges.reserve(prisms.size());
    for (const Prism& prism : prisms) {
        edges.emplace_back();
        for (std::size_t i = 0; i < prism.size(); ++i) edges.back()[i] = {prism[i].a, prism[i].b};
    }
    return view().seen_as_whole(edges);
}

std::vector<Rgb> LitPoint::illuminance_by_light(const ClearCoat* coat) const {
    return by_light([&](const LightSource& source, std::span<const int> lamps,
                        std::span<const SeenLight> seen) {
        return illuminance_by_lamp(source, lamps, seen, rig_.medium, point_, normal_, model_, coat);
    });
}

std::vector<SeenLight> ShadowedRig::seen_from(const Vec3& point, const Vec3& normal,
                                              const std::optional<Root>& root,
                                              std::span<const RigLight> lights, TubeModel model,
                                              bool axes) const {
    std::vector<SeenLight> all;
    each_source(lights, [&](std::size_t i, std::span<const int> lamps, std::size_t) {
        const LightSource& source = rig_.sources[i];
        const SeenPast visible(
            occluders_, tracer_, Apex::at(point, root),
            occluders_ ? source_region(source, lamps, point) : std::vector<Vec3>(),
            occluders_ ? source_segments(source, lamps) : std::vector<Segment>(), normal);
        for (SeenLight& seen : seen_lights(source, lamps, point, normal, visible, model,
                                           axes || rig_.medium.has_value()))
            all.push_back(std::move(seen));
    });
    return all;
}

} // namespace keiko
