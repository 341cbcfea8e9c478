#include "keiko/trace/tracer.h"

#include "keiko/trace/embree_scene.h"
#include "keiko/trace/leaf_hits.h"
#include "keiko/trace/merge_hits.h"
#include "keiko/trace/traced_model.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

std::vector<Box3> boxes_of(const TracedModel& model, const std::vector<PlacedLeaf>& leaves) {
    std::vector<Box3> boxes;
    boxes.reserve(leaves.size());
    for (const PlacedLeaf& leaf : leaves) boxes.push_back(model.bounds(leaf));
    return boxes;
}

} // namespace

struct Tracer::Scene {
    TracerOptions options;
    TracedModel model;
    std::vector<PlacedLeaf> leaves;
    EmbreeScene boxes;
    TracerStatistics statistics;

    Scene(const SurfaceModel& source, const TracerOptions& chosen, const Job& job)
        : options(chosen),
          model(traced_model(source, chosen.join, job)),
          leaves(model.placed_leaves()),
          boxes(boxes_of(model, leaves), job.threads) {}

    template <class Visit>
    void trace(const Ray& ray, const Visit& visit) const;
    BorderHit border_hit(const Candidate& candidate) const;
};

namespace {

/// The stretch of a ray inside the ball around a scene.
struct Entry {
    TracedRay ray;
    Vec3 direction{0};            ///< unit
    double begin = 0;             ///< t at the stretch's start
    double speed = 0, length = 0; ///< mm per unit of t; mm within the ball
};

std::optional<Entry> enter(const Ray& ray, const EmbreeScene& scene) {
    const double speed = ray.direction.length();
    if (!is_finite(ray.origin) || !(speed > 0 && std::isfinite(speed)) || scene.bounds().empty())
        return std::nullopt;
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    Entry entry;
    entry.direction = ray.direction / speed;
    entry.speed = speed;
    const Vec3 to_center = scene.center() - ray.origin;
    const double foot = to_center.dot(entry.direction);
    const Vec3 off = to_center - entry.direction * foot;
    // Far origins blur the ball's border: whatever may touch it must come in.
    const double ball = scene.radius() * 1.001 + 64 * epsilon * to_center.length();
    const double half2 = ball * ball - off.dot(off);
    if (!(half2 >= 0)) return std::nullopt;
    const double half = std::sqrt(half2);
    entry.begin = std::max(ray.t_min, (foot - half) / speed);
    const double end = std::min(ray.t_max, (foot + half) / speed);
    if (!(entry.begin <= end)) return std::nullopt;
    entry.length = (end - entry.begin) * speed;
    // Not t_min: a hit's t must have the same last bit whatever range it is asked in.
    const double start = to_center.length() <= ball ? 0 : (foot - half) / speed;
    entry.ray = {.ray = &ray,
                 .t_start = start,
                 .start = ray.at(start),
                 .error = 2 * epsilon * (ray.origin.length() + std::abs(start) * speed)};
    return entry;
}

bool at_border(const Leaf& leaf, const Candidate& candidate) {
    constexpr double near = 1e-8;
    for (const double x : {candidate.uv.x, candidate.uv.y})
        if (!(x > near && x < 1 - near)) return true;
    return leaf.trim == TrimSide::mixed;
}

} // namespace

/// `visit(candidates)` returns the largest t still of interest, -infinity to stop.
template <class Visit>
void Tracer::Scene::trace(const Ray& ray, const Visit& visit) const {
    const std::optional<Entry> entry = enter(ray, boxes);
    if (!entry) return;
    struct LeafVisitor final : EmbreeScene::Visitor {
        const Scene& scene;
        const Entry& entry;
        const Visit& visit_hits;
        double limit = std::numeric_limits<double>::infinity();

        LeafVisitor(const Scene& s, const Entry& e, const Visit& v)
            : scene(s), entry(e), visit_hits(v) {}
        double visit(std::uint32_t box) override {
            limit = visit_hits(leaf_hits(scene.model, scene.leaves[box], entry.ray,
                                         scene.options.clipping_only, limit));
            if (limit == -std::numeric_limits<double>::infinity()) return -1;
            return std::clamp((limit - entry.begin) * entry.speed, 0.0, entry.length);
        }
    };
    LeafVisitor visitor(*this, *entry, visit);
    boxes.trace(ray.at(entry->begin), entry->direction, entry->length, visitor);
}

BorderHit Tracer::Scene::border_hit(const Candidate& candidate) const {
    const Leaf& leaf = model.leaves.leaves[candidate.placed.leaf];
    const double reach = candidate.seam == no_index
                             ? 0
                             : std::min(model.edges[candidate.seam].tolerance, options.join);
    return {evaluated(model, candidate, options.second_derivatives), at_border(leaf, candidate),
            reach};
}

Tracer::Tracer(const SurfaceModel& model, const TracerOptions& options, const Job& job) {
    const auto begin = std::chrono::steady_clock::now();
    scene_ = std::make_unique<Scene>(model, options, job);
    TracerStatistics& s = scene_->statistics;
    s.leaves = scene_->leaves.size();
    s.leaves_trimmed_away = scene_->model.leaves.trimmed_away;
    for (const PlacedLeaf& placed : scene_->leaves)
        s.leaves_mixed += scene_->model.leaves.leaves[placed.leaf].trim == TrimSide::mixed;
    s.bytes = scene_->model.bytes() + scene_->leaves.size() * sizeof(PlacedLeaf);
    s.build_seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

Tracer::~Tracer() = default;
Tracer::Tracer(Tracer&&) noexcept = default;
Tracer& Tracer::operator=(Tracer&&) noexcept = default;

std::optional<Hit> Tracer::nearest(const Ray& ray) const {
    std::optional<Candidate> best;
    scene_->trace(ray, [&](std::span<const Candidate> found) {
        for (const Candidate& c : found)
            if (!best || c.before(*best)) best = c;
        return best ? best->t : std::numeric_limits<double>::infinity();
    });
    if (!best) return std::nullopt;
    return evaluated(scene_->model, *best, scene_->options.second_derivatives);
}

bool Tracer::any(const Ray& ray) const {
    bool hit = false;
    scene_->trace(ray, [&](std::span<const Candidate> found) {
        hit = hit || !found.empty();
        return hit ? -std::numeric_limits<double>::infinity()
                   : std::numeric_limits<double>::infinity();
    });
    return hit;
}

std::vector<Hit> Tracer::all(const Ray& ray) const {
    std::vector<Candidate> candidates;
    scene_->trace(ray, [&](std::span<const Candidate> found) {
        candidates.insert(candidates.end(), found.begin(), found.end());
        return std::numeric_limits<double>::infinity();
    });
    std::sort(candidates.begin(), candidates.end(),
              [](const Candidate& a, const Candidate& b) { return a.before(b); });
    std::vector<BorderHit> hits;
    for (const Candidate& c : candidates) hits.push_back(scene_->border_hit(c));
    return merged(std::move(hits), ray.direction.length());
}

std::vector<std::optional<Hit>> Tracer::nearest(std::span<const Ray> rays) const {
    std::vector<std::optional<Hit>> hits;
    hits.reserve(rays.size());
    for (const Ray& ray : rays) hits.push_back(nearest(ray));
    return hits;
}

std::vector<bool> Tracer::any(std::span<const Ray> rays) const {
    std::vector<bool> hits;
    hits.reserve(rays.size());
    for (const Ray& ray : rays) hits.push_back(any(ray));
    return hits;
}

std::vector<std::vector<Hit>> Tracer::all(std::span<const Ray> rays) const {
    std::vector<std::vector<Hit>> hits;
    hits.reserve(rays.size());
    for (const Ray& ray : rays) hits.push_back(all(ray));
    return hits;
}

const TracerStatistics& Tracer::statistics() const {
    return scene_->statistics;
}
const Box3& Tracer::bounds() const {
    return scene_->boxes.bounds();
}

} // namespace keiko
