#include "keiko/placement/best_view.h"

#include "keiko/base/error.h"
#include "keiko/base/parallel.h"
#include "keiko/base/units.h"
#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/placement/view_samples.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keiko {
namespace {

/// Names of candidates in the order of preference.
constexpr std::array<std::string_view, 17> candidates{"three-quarter-front-left",
                                                      "three-quarter-front-right",
                                                      "three-quarter-rear-left",
                                                      "three-quarter-rear-right",
                                                      "high-three-quarter-front-left",
                                                      "high-three-quarter-front-right",
                                                      "high-three-quarter-rear-left",
                                                      "high-three-quarter-rear-right",
                                                      "left",
                                                      "right",
                                                      "front",
                                                      "rear",
                                                      "high-left",
                                                      "high-right",
                                                      "high-front",
                                                      "high-rear",
                                                      "top"};
constexpr int test_width = 64;  ///< pixels
constexpr double clearly = 1.1; ///< factor by which a later candidate must be better
constexpr double other_side = degrees_to_radians(35); ///< least angle between two views
constexpr double least_share = 0.25; ///< of the best score, that a further view must reach
constexpr double outer_bonus = 0.5;  ///< largest change of a hit's worth by curvature

/// Worth of an incidence: small near grazing, where the picture is squeezed, and somewhat less
/// straight on, where the camera stands among the lamps that it would reflect.
double worth(double cosine) {
    const double t = std::clamp((cosine - 0.15) / 0.35, 0.0, 1.0);
    const double not_grazing = t * t * (3 - 2 * t);
    return not_grazing * (1 - 0.4 * std::pow(cosine, 8));
}

/// -1 if the surface is hollow towards the camera, 1 if it bulges, 0 if it is flat.
double bulge(const SurfaceModel& model, const Hit& hit, const Vec3& normal, double size) {
    const SurfaceDerivatives s = world_derivatives(model, hit);
    if (!(s.du().cross(s.dv()).length() > 1e-9 * s.du().length() * s.dv().length())) return 0;
    return std::tanh(-4 * principal_curvatures(s, normal).mean() * size);
}

double score(const Tracer& tracer, const SurfaceModel& model, const Camera& camera) {
    std::vector<Ray> rays;
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) rays.push_back(camera.ray(x + 0.5, y + 0.5));
    const std::vector<std::optional<Hit>> hits = tracer.nearest(rays);
    const double size = tracer.bounds().size();
    double sum = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!hits[i]) continue;
        const Vec3 normal = facing_normal(*hits[i], rays[i]);
        const double side = bulge(model, *hits[i], normal, size);
        sum += worth(-normal.dot(rays[i].direction)) * (1 + outer_bonus * side);
    }
    return sum / static_cast<double>(rays.size());
}

std::vector<NamedView> scored_candidates(const Tracer& tracer, const SurfaceModel& model,
                                         const Framing& framing, const Job& job) {
    Framing small = framing;
    small.width = test_width;
    small.height = std::max(1, test_width * framing.height / framing.width);
    std::vector<NamedView> views(candidates.size());
    parallel_for(candidates.size(), job, "choose view", [&](std::size_t i) {
        const Box3& box = tracer.bounds();
        views[i] = {std::string(candidates[i]), frame_view(candidates[i], box, framing),
                    score(tracer, model, frame_view(candidates[i], box, small))};
    });
    return views;
}

/// True if the view shows the body from another side than all of those.
bool differs(const NamedView& view, std::span<const NamedView> chosen) {
    const Vec3 towards = view.camera.target - view.camera.eye;
    return std::all_of(chosen.begin(), chosen.end(), [&](const NamedView& other) {
        return angle_between(towards, other.camera.target - other.camera.eye) > other_side;
    });
}

} // namespace

std::vector<NamedView> best_views(const Tracer& tracer, const SurfaceModel& model, int count,
                                  const Framing& framing, const Job& job) {
    const std::vector<NamedView> all = scored_candidates(tracer, model, framing, job);
    std::vector<NamedView> chosen;
    while (chosen.size() < static_cast<std::size_t>(count)) {
        const NamedView* best = nullptr;
        for (const NamedView& view : all)
            if (differs(view, chosen) && (!best || view.score > best->score * clearly))
                best = &view;
        if (!best || (!chosen.empty() && best->score < least_share * chosen.front().score)) break;
        chosen.push_back(*best);
    }
    return chosen;
}

std::vector<Camera> cameras_of(std::span<const NamedView> views) {
    std::vector<Camera> cameras;
    for (const NamedView& view : views) cameras.push_back(view.camera);
    return cameras;
}

NamedView best_view(const Tracer& tracer, const SurfaceModel& model, const Framing& framing,
                    const Job& job) {
    return best_views(tracer, model, 1, framing, job).front();
}

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
