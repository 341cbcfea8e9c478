#pragma once

#include "keiko/intersect/traversal/tracer.h"

#include <optional>

namespace keiko {

/// Statistics of a model's ray tracer. Except for the time, they are the same for every run and
/// thread count.
struct TraceFacts {
    std::size_t sub_patches = 0;       ///< placed pieces of patches that rays are tested against
    std::size_t mixed_sub_patches = 0; ///< those of them that trim curves cut
    std::size_t trimmed_away_sub_patches = 0; ///< left out, since trimming removes all of them
    std::size_t bytes = 0; ///< of Keiko's own records, without Embree's box hierarchy
    std::optional<double> build_milliseconds{};
};

/// Facts without the time, which differs from run to run.
TraceFacts trace_facts(const TracerStatistics& statistics);
TraceFacts timed_trace_facts(const TracerStatistics& statistics);

} // namespace keiko
