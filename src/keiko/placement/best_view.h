#pragma once

#include "keiko/base/export.h"
#include "keiko/base/job.h"
#include "keiko/intersect/traversal/tracer.h"
#include "keiko/placement/view_samples.h"
#include "keiko/scene/view.h"

#include <span>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// A named view: its camera.
struct NamedView {
    std::string name; ///< as in view_names(), or of a file
    Camera camera;    ///< the view itself
    double score = 0; ///< share of the picture that shows the part well, about 0 to 1
};

/// Cameras of all views, in their order.
std::vector<Camera> cameras_of(std::span<const NamedView> views);

/// Chooses the view that shows a part well: large in the picture, at incidences with clear
/// reflections, and for sheet panels from the convex, outer side. It tests the eight level or
/// slightly raised views, the same from high above, and top, on small pictures; the first of
/// equally good ones wins. Throws Error for an empty model.
NamedView best_view(const Tracer& tracer, const SurfaceModel& model, const Framing& framing = {},
                    const Job& job = {});

/// Up to `count` (at least 1) such views from different sides, the best first; fewer if no other
/// side shows much.
std::vector<NamedView> best_views(const Tracer& tracer, const SurfaceModel& model, int count,
                                  const Framing& framing = {}, const Job& job = {});

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
