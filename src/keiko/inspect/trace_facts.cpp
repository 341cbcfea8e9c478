#include "keiko/inspect/trace_facts.h"

namespace keiko {

TraceFacts trace_facts(const TracerStatistics& statistics) {
    return {.leaves = statistics.leaves,
            .mixed_leaves = statistics.leaves_mixed,
            .trimmed_away_leaves = statistics.leaves_trimmed_away,
            .bytes = statistics.bytes};
}

TraceFacts timed_trace_facts(const TracerStatistics& statistics) {
    TraceFacts facts = trace_facts(statistics);
    facts.build_milliseconds = 1e3 * statistics.build_seconds;
    return facts;
}

} // namespace keiko
