#pragma once

#include "keiko/placement/best_view.h"
#include "keiko/placement/view_samples.h"

#include <string>
#include <vector>

namespace keiko {

/// Mirror samples of pictures of a body, registered during rendering. Lamps can be placed by them
/// without tracing the body again.
struct RegisteredHits {
    std::vector<NamedView> views;
    std::vector<ViewSample> samples; ///< of all faces, each with its solid angle as weight
    std::size_t faces = 0, instances = 0;
    Box3 body;

    /// The samples of the faces that count, weighted by the options. Throws Error for hits of a
    /// body with other faces.
    std::vector<ViewSample> chosen(const SurfaceModel& model, const Box3& bounds,
                                   const SamplingOptions& options) const;
};

/// Registered hits of views of one body, the same samples that place_lamps computes itself.
RegisteredHits register_hits(const Tracer& tracer, const SurfaceModel& model,
                             std::vector<NamedView> views, const Job& job = {});

} // namespace keiko
