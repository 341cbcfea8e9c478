#include "keiko/placement/registered_hits.h"

#include "keiko/base/error.h"

#include <algorithm>

namespace keiko {

std::vector<ViewSample> RegisteredHits::chosen(const SurfaceModel& model, const Box3& bounds,
                                               const SamplingOptions& options) const {
    if (faces != model.faces.size() || instances != model.instances.size() ||
        body.lower != bounds.lower || body.upper != bounds.upper)
        throw FieldError("hits", "the hits were registered on another body");
    std::vector<ViewSample> kept;
    for (const ViewSample& s : samples) {
        const auto& wanted = options.faces;
        if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), s.face) == wanted.end())
            continue;
        kept.push_back(s);
        if (options.weight == SampleWeight::pixels) kept.back().weight = double(s.edge) * s.edge;
    }
    return kept;
}

RegisteredHits register_hits(const Tracer& tracer, const SurfaceModel& model,
                             std::vector<NamedView> views, const Job& job) {
    std::vector<ViewSample> samples = sample_views(tracer, model, cameras_of(views), {}, job);
    return {std::move(views), std::move(samples), model.faces.size(), model.instances.size(),
            tracer.bounds()};
}

} // namespace keiko
