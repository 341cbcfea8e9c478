#pragma once

#include "keiko/visibility/query/occluders.h"

#include "tests/support/random.h"

#include <string>

namespace keiko::test {

/// Counts of dense probing by single rays of intervals that were found exactly.
struct ProbeCounts {
    std::size_t segments = 0, partly_hidden = 0, uncertain = 0, probes = 0;
    std::size_t wrong_segments = 0; ///< with a probe that disagrees, not next to an interval's end
    std::string first_wrong;

    std::string text() const;
};

/// A body that random viewpoints on it and around it look out from.
class VisibilityProbe {
public:
    explicit VisibilityProbe(const SurfaceModel& model);

    enum class From { surface, space, infinity };
    /// One random viewpoint with `lamps` parallel segments over the body, each probed at `probes`
    /// places.
    void look(From from, int lamps, int probes, Random& random, ProbeCounts& counts) const;

    const Occluders& occluders() const { return occluders_; }

private:
    std::optional<Viewpoint> random_apex(From from, Random& random) const;

    Tracer tracer_;
    Occluders occluders_;
};

} // namespace keiko::test
