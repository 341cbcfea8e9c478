#pragma once

#include "keiko/intersect/traversal/tracer.h"
#include "keiko/math/interval_set.h"
#include "keiko/visibility/boundaries/plane_cuts.h"

#include <cstdint>
#include <span>
#include <vector>

namespace keiko {

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

/// The stretches of `asked` between events, sorted here; those shorter than 1e-9 are dropped.
std::vector<EventInterval> event_intervals(std::vector<VisibilityEvent>& events,
                                           const ParameterInterval& asked);

/// Gaps of several segments; some are known to be visible or hidden together: one ray
/// classifies each group that is still unknown.
class IntervalClasses {
public:
    /// Adds a segment's gaps; returns the number of the first of them, the others follow. `plane`
    /// must stay where it is until classify() is done.
    std::size_t add(const SegmentPlane& plane, std::vector<EventInterval> gaps);
    /// Puts the groups of two gaps together.
    void join(std::size_t a, std::size_t b) { leader_[root(a)] = root(b); }
    /// Asks for all groups at once.
    void classify(const Tracer& tracer);
    /// Visible parts of a segment, after classify(): `first` as add() returned it.
    IntervalSet seen(std::size_t first, std::size_t count) const;

    /// The i-th gap; its `dark` is that of its group after classify().
    const EventInterval& gap(std::size_t i) const { return gaps_[i]; }
    /// Number of gaps of all segments.
    std::size_t size() const { return gaps_.size(); }

private:
    std::size_t root(std::size_t i) {
        while (leader_[i] != i) i = leader_[i] = leader_[leader_[i]];
        return i;
    }

    std::vector<EventInterval> gaps_;
    std::vector<std::size_t> leader_;
    std::vector<const SegmentPlane*> planes_;
};

} // namespace keiko
