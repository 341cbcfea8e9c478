#include "keiko/visibility/query/event_intervals.h"

#include <algorithm>

namespace keiko {
namespace {

/// Share of a segment below which parts and gaps are dropped (docs/theory/visibility.md#events).
constexpr double shortest = 1e-9;
/// Share of a segment within which events are taken as one, whose sides say nothing if they differ.
constexpr double same_event = 1e-11;

} // namespace

std::vector<EventInterval> event_intervals(std::vector<VisibilityEvent>& events,
                                           const ParameterInterval& asked) {
    std::erase_if(events, [&](const auto& e) { return !(e.t >= asked.begin && e.t <= asked.end); });
    std::sort(events.begin(), events.end(), [](const auto& x, const auto& y) { return x.t < y.t; });
    std::vector<EventInterval> gaps;
    EventInterval open{asked.begin, asked.end, false};
    for (std::size_t i = 0; i < events.size();) {
        std::size_t next = i;
        bool below = false, above = false, all = true;
        for (; next < events.size() && events[next].t - events[i].t <= same_event; ++next) {
            below = below || events[next].dark < 0;
            above = above || events[next].dark > 0;
            all = all && events[next].dark != 0;
        }
        const bool sure = all && below != above;
        open.end = events[i].t;
        open.dark = open.dark || (sure && below);
        gaps.push_back(open);
        open = {events[next - 1].t, asked.end, sure && above};
        i = next;
    }
    gaps.push_back(open);
    std::erase_if(gaps, [](const EventInterval& g) { return !(g.length() > shortest); });
    return gaps;
}

std::size_t IntervalClasses::add(const SegmentPlane& plane, std::vector<EventInterval> gaps) {
    const std::size_t first = gaps_.size();
    for (const EventInterval& gap : gaps) {
        leader_.push_back(gaps_.size());
        gaps_.push_back(gap);
        planes_.push_back(&plane);
    }
    return first;
}

void IntervalClasses::classify(const Tracer& tracer) {
    std::vector<bool> dark(gaps_.size());
    std::vector<std::size_t> longest(gaps_.size());
    for (std::size_t i = 0; i < gaps_.size(); ++i) longest[i] = i;
    for (std::size_t i = 0; i < gaps_.size(); ++i) {
        const std::size_t group = root(i);
        dark[group] = dark[group] || gaps_[i].dark;
        if (gaps_[i].length() > gaps_[longest[group]].length()) longest[group] = i;
    }
    std::vector<Ray> rays;
    std::vector<std::size_t> asked;
    for (std::size_t i = 0; i < gaps_.size(); ++i)
        if (leader_[i] == i && !dark[i]) {
            const SegmentPlane& plane = *planes_[longest[i]];
            rays.push_back(plane.viewpoint().ray_to(plane.at(gaps_[longest[i]].inside())));
            asked.push_back(i);
        }
    const std::vector<bool> hidden = tracer.any(std::span<const Ray>(rays));
    for (std::size_t k = 0; k < asked.size(); ++k) dark[asked[k]] = hidden[k];
    for (std::size_t i = 0; i < gaps_.size(); ++i) gaps_[i].dark = dark[root(i)];
}

IntervalSet IntervalClasses::seen(std::size_t first, std::size_t count) const {
    std::vector<ParameterInterval> parts;
    for (const EventInterval& gap : std::span(gaps_).subspan(first, count)) {
        if (gap.dark) continue;
        if (!parts.empty() && gap.begin - parts.back().end <= shortest)
            parts.back().end = gap.end;
        else
            parts.push_back({gap.begin, gap.end});
    }
    return IntervalSet(std::move(parts));
}

} // namespace keiko
