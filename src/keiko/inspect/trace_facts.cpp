#include "keiko/inspect/trace_facts.h"

namespace keiko {

TraceFacts trace_facts(const TracerStatistics& statistics) {
    return {.sub_patches = statistics.sub_patches,
            .mixed_sub_patches = statistics.sub_patches_mixed,
            .trimmed_away_sub_patches = statistics.sub_patches_trimmed_away,
            .bytes = statistics.bytes};
}

TraceFacts timed_trace_facts(const TracerStatistics& statistics) {
    TraceFacts facts = trace_facts(statistics);
    facts.build_milliseconds = 1e3 * statistics.build_seconds;
    return facts;
}

} // namespace keiko
