#pragma once

#include "keiko/base/export.h"
#include "keiko/placement/best_view.h"
#include "keiko/placement/view_samples.h"

#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// Mirror samples of pictures of a body, registered during rendering. Lamps can be placed by them
/// without tracing the body again.
struct RegisteredHits {
    std::vector<NamedView> views;         ///< of the pictures, in order
    std::vector<ViewSample> samples;      ///< of all faces, each with its solid angle as weight
    std::size_t faces = 0, instances = 0; ///< of the model, to recognise it by
    Box3 body;                            ///< box of the model, mm

    /// The samples of the faces that count, weighted by the options. Throws Error for hits of a
    /// body with other faces.
    std::vector<ViewSample> chosen(const SurfaceModel& model, const Box3& bounds,
                                   const SamplingOptions& options) const;
};

/// Registered hits of views of one body, the same samples that place_lamps computes itself.
RegisteredHits register_hits(const Tracer& tracer, const SurfaceModel& model,
                             std::vector<NamedView> views, const Job& job = {});

} // namespace keiko
