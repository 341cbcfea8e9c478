#pragma once

#include "keiko/intersect/traversal/tracer.h"
#include "keiko/math/interval_set.h"
#include "keiko/visibility/boundaries/plane_cuts.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace keiko {

/// Share of a segment below which visible parts and the intervals between them are dropped
/// (docs/theory/visibility.md#events).
constexpr double shortest_interval = 1e-9;

/// A stretch of a segment between two events: seen or hidden as a whole.
struct EventInterval {
    double begin = 0, end = 0; ///< parameters of the segment
    bool dark = false;         ///< known to be hidden

    /// Length in the segment's parameter.
    double length() const { return end - begin; }
    /// A place well inside that round numbers do not hit: rays that touch a body at one place alone
    /// would be classified wrongly there.
    double inside() const { return begin + 0.4863 * length(); }
};

/// The stretches of `asked` between events, sorted here; those of shortest_interval and less are
/// dropped.
std::vector<EventInterval> event_intervals(std::vector<VisibilityEvent>& events,
                                           const ParameterInterval& asked);

/// Event intervals of several segments. Some are known to be visible or hidden together: one ray
/// classifies each group that is still unknown.
class IntervalClasses {
public:
    /// Adds a segment's intervals; returns the number of the first of them, the others follow.
    /// `plane` must stay where it is until classify() is done.
    std::size_t add(const SegmentPlane& plane, std::span<const EventInterval> intervals);
    /// Puts the groups of two intervals together.
    void join(std::size_t a, std::size_t b) { leader_[root(a)] = root(b); }
    /// Asks for all groups at once.
    void classify(const Tracer& tracer);
    /// Visible parts of a segment, after classify(): `first` as add() returned it.
    IntervalSet seen(std::size_t first, std::size_t count) const;

    /// The i-th interval; its `dark` is that of its group after classify().
    const EventInterval& interval(std::size_t i) const { return intervals_[i]; }
    /// Number of intervals of all segments.
    std::size_t size() const { return intervals_.size(); }

private:
    std::size_t root(std::size_t i) {
        while (leader_[i] != i) i = leader_[i] = leader_[leader_[i]];
        return i;
    }

    std::vector<EventInterval> intervals_;
    std::vector<std::size_t> leader_;
    std::vector<const SegmentPlane*> planes_;
};

inline std::vector<EventInterval> event_intervals(std::vector<VisibilityEvent>& events,
                                                  const ParameterInterval& asked) {
    // Share of a segment within which events are taken as one, whose sides say nothing if they
    // differ.
    constexpr double same_event = 1e-11;
    std::erase_if(events, [&](const auto& e) { return !(e.t >= asked.begin && e.t <= asked.end); });
    std::sort(events.begin(), events.end(), [](const auto& x, const auto& y) { return x.t < y.t; });
    std::vector<EventInterval> intervals;
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
        intervals.push_back(open);
        open = {events[next - 1].t, asked.end, sure && above};
        i = next;
    }
    intervals.push_back(open);
    std::erase_if(intervals,
                  [](const EventInterval& g) { return !(g.length() > shortest_interval); });
    return intervals;
}

inline std::size_t IntervalClasses::add(const SegmentPlane& plane,
                                        std::span<const EventInterval> intervals) {
    const std::size_t first = intervals_.size();
    for (const EventInterval& interval : intervals) {
        leader_.push_back(intervals_.size());
        intervals_.push_back(interval);
        planes_.push_back(&plane);
    }
    return first;
}

inline void IntervalClasses::classify(const Tracer& tracer) {
    std::vector<bool> dark(intervals_.size());
    std::vector<std::size_t> longest(intervals_.size());
    for (std::size_t i = 0; i < intervals_.size(); ++i) longest[i] = i;
    for (std::size_t i = 0; i < intervals_.size(); ++i) {
        const std::size_t group = root(i);
        dark[group] = dark[group] || intervals_[i].dark;
        if (intervals_[i].length() > intervals_[longest[group]].length()) longest[group] = i;
    }
    std::vector<Ray> rays;
    std::vector<std::size_t> asked;
    for (std::size_t i = 0; i < intervals_.size(); ++i)
        if (leader_[i] == i && !dark[i]) {
            const SegmentPlane& plane = *planes_[longest[i]];
            rays.push_back(plane.viewpoint().ray_to(plane.at(intervals_[longest[i]].inside())));
            asked.push_back(i);
        }
    const std::vector<bool> hidden = tracer.any(std::span<const Ray>(rays));
    for (std::size_t k = 0; k < asked.size(); ++k) dark[asked[k]] = hidden[k];
    for (std::size_t i = 0; i < intervals_.size(); ++i) intervals_[i].dark = dark[root(i)];
}

inline IntervalSet IntervalClasses::seen(std::size_t first, std::size_t count) const {
    std::vector<ParameterInterval> parts;
    for (const EventInterval& interval : std::span(intervals_).subspan(first, count)) {
        if (interval.dark) continue;
        if (!parts.empty() && interval.begin - parts.back().end <= shortest_interval)
            parts.back().end = interval.end;
        else
            parts.push_back({interval.begin, interval.end});
    }
    return IntervalSet(std::move(parts));
}

} // namespace keiko
