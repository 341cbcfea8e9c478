#include "keiko/intersect/traversal/tracer.h"

#include "keiko/base/parallel.h"
#include "keiko/geometry/trim/material_bounds.h"
#include "keiko/intersect/hit/merge_hits.h"
#include "keiko/intersect/hit/surface_interaction.h"
#include "keiko/intersect/kernels/prefetch.h"
#include "keiko/intersect/traversal/packet_intersector.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>
#include <utility>

namespace keiko {
namespace {

std::vector<Box3> boxes_of(const TracedModel& model, const Job& job) {
    std::vector<Box3> boxes(model.placed.size());
    parallel_for(boxes.size(), job, "",
                 [&](std::size_t i) { boxes[i] = model.bounds(model.placed[i]); });
    return boxes;
}

std::optional<Hit> first_of(std::vector<Hit> hits) {
    return hits.empty() ? std::nullopt : std::optional(std::move(hits.front()));
}

PacketIntersector& block_search() {
    thread_local PacketIntersector search;
    return search;
}

} // namespace

struct Tracer::Scene {
    TracerOptions options;
    TracedModel model;
    std::vector<Box3> sub_patch_boxes;
    EmbreeScene boxes;
    Box3 material;
    SubPatchKernels kernels = sub_patch_kernels();
    TracerStatistics statistics;

    Scene(const SurfaceModel& source, const TracerOptions& chosen, const Job& job)
        : options(chosen),
          model(traced_model(source, chosen.join, chosen.sub_patch_contraction, job)),
          sub_patch_boxes(boxes_of(model, job)),
          boxes(sub_patch_boxes, job.threads),
          material(material_bounds(source, job)) {
        if (!options.clipping_only) return;
        for (PackedSubPatch& sub_patch : model.hot) sub_patch.set_unbounded();
    }

    /// All that Tracer::all has of a ray that crosses the model there.
    std::vector<Hit> merged_hits(const Ray& ray, std::span<const Crossing> crossings) const;
    SurfaceInteraction evaluation() const { return {model, kernels, options.second_derivatives}; }
    Hit evaluate(const Crossing& crossing) const {
        return evaluated(model, kernels, crossing, options.second_derivatives);
    }
};

/// Sub-patches that rays pass through, and those that they do not.
struct Tracer::Hidden {
    std::vector<bool> sub_patches; ///< by placed sub-patch whether it is hidden
    std::vector<Box3> boxes;       ///< of the others

    Hidden(const Scene& scene, const std::vector<bool>& faces);
};

Tracer::Hidden::Hidden(const Scene& scene, const std::vector<bool>& faces) {
    const TracedModel& model = scene.model;
    assert(faces.size() == model.faces.size());
    sub_patches.reserve(model.placed.size());
    for (std::size_t i = 0; i < model.placed.size(); ++i) {
        const SubPatch& sub_patch = model.sub_patches.sub_patches[model.placed[i].sub_patch];
        sub_patches.push_back(faces[model.patches[sub_patch.patch].face]);
        if (!sub_patches.back()) boxes.push_back(scene.sub_patch_boxes[i]);
    }
}

template <class Work>
void Tracer::each_block(std::span<const Ray> rays, const Work& work) const {
    if (boxes().empty()) return;
    PacketIntersector& search = block_search();
    const SearchScene scene{scene_->model, scene_->boxes, scene_->kernels,
                            scene_->options.clipping_only,
                            hidden_ ? &hidden_->sub_patches : nullptr};
    for (std::size_t begin = 0; begin < rays.size(); begin += RayPacket::capacity) {
        const std::size_t count = std::min(RayPacket::capacity, rays.size() - begin);
        // Read when the block before them is done.
        prefetch(rays.subspan(begin + count,
                              std::min(RayPacket::capacity, rays.size() - begin - count)));
        work(search, scene, begin, rays.subspan(begin, count));
    }
}

Tracer::Tracer(const SurfaceModel& model, const TracerOptions& options, const Job& job) {
    const auto begin = std::chrono::steady_clock::now();
    const auto scene = std::make_shared<Scene>(model, options, job);
    TracerStatistics& s = scene->statistics;
    s.sub_patches = scene->model.placed.size();
    s.sub_patches_trimmed_away = scene->model.sub_patches.trimmed_away;
    for (const PlacedSubPatch& placed : scene->model.placed)
        s.sub_patches_mixed +=
            scene->model.sub_patches.sub_patches[placed.sub_patch].trim == TrimSide::mixed;
    s.bytes = scene->model.bytes();
    s.instruction_set = scene->kernels.name;
    s.build_seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    scene_ = scene;
}

Tracer::Tracer(std::shared_ptr<const Scene> scene, std::shared_ptr<const Hidden> hidden)
    : scene_(std::move(scene)), hidden_(std::move(hidden)) {}

Tracer Tracer::without(const std::vector<bool>& hidden) const {
    return {scene_, std::make_shared<const Hidden>(*scene_, hidden)};
}

void Tracer::find_nearest(std::span<const Ray> rays, std::span<Crossing> found) const {
    each_block(rays, [&](PacketIntersector& search, const SearchScene& scene, std::size_t begin,
                         std::span<const Ray> block) {
        search.nearest(scene, block, found.subspan(begin, block.size()));
    });
}

std::optional<Hit> Tracer::hit_of(const Ray& ray, const Crossing& crossing) const {
    if (has(crossing.flags, HitFlags::seam)) return first_of(all(ray));
    std::optional<Hit> hit;
    if (crossing) scene_->evaluation().write_whole(crossing, hit.emplace());
    return hit;
}

std::optional<Hit> Tracer::nearest(const Ray& ray) const {
    Crossing first;
    find_nearest(std::span(&ray, 1), std::span(&first, 1));
    return hit_of(ray, first);
}

bool Tracer::any(const Ray& ray) const {
    bool hit = false;
    each_block(std::span(&ray, 1),
               [&](PacketIntersector& search, const SearchScene& scene, std::size_t,
                   std::span<const Ray> block) { hit = search.any(scene, block) != 0; });
    return hit;
}

std::vector<Hit> Tracer::all(const Ray& ray) const {
    return std::move(all(std::span(&ray, 1)).front());
}

std::vector<Crossing> Tracer::nearest_crossings(std::span<const Ray> rays) const {
    std::vector<Crossing> found(rays.size());
    find_nearest(rays, found);
    return found;
}

Hit Tracer::evaluate(const Crossing& crossing) const {
    return scene_->evaluate(crossing);
}

template <class Slot, class Replace>
void Tracer::evaluate(std::span<const Ray> rays, std::span<const Crossing> crossings,
                      HitDetail detail, const Slot& slot, const Replace& replace) const {
    std::vector<Ray> in_seams;
    SurfaceInteraction evaluation = scene_->evaluation();
    constexpr std::size_t ahead = HitPacket::capacity;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (detail == HitDetail::all && i + ahead < rays.size() && crossings[i + ahead])
            evaluation.announce(crossings[i + ahead]);
        if (has(crossings[i].flags, HitFlags::seam))
            in_seams.push_back(rays[i]);
        else if (crossings[i] && detail == HitDetail::all)
            evaluation.add(crossings[i], slot(i));
        else if (crossings[i])
            evaluation.write_face(crossings[i], slot(i));
    }
    evaluation.finish();
    std::vector<std::vector<Hit>> all_there = all(in_seams);
    auto next = all_there.begin();
    for (std::size_t i = 0; i < rays.size() && next != all_there.end(); ++i)
        if (has(crossings[i].flags, HitFlags::seam)) replace(i, first_of(std::move(*next++)));
}

std::vector<std::optional<Hit>> Tracer::nearest(std::span<const Ray> rays) const {
    std::vector<std::optional<Hit>> hits(rays.size());
    evaluate(
        rays, nearest_crossings(rays), HitDetail::all,
        [&](std::size_t i) -> Hit& { return hits[i].emplace(); },
        [&](std::size_t i, std::optional<Hit> hit) { hits[i] = std::move(hit); });
    return hits;
}

FirstHits Tracer::first_hits(std::span<const Ray> rays, HitDetail detail) const {
    const std::vector<Crossing> crossings = nearest_crossings(rays);
    FirstHits found;
    found.of_ray.reserve(rays.size());
    std::uint32_t count = 0;
    for (const Crossing& crossing : crossings)
        found.of_ray.push_back(crossing ? count++ : no_index);
    found.hits.resize(count);
    evaluate(
        rays, crossings, detail, [&](std::size_t i) -> Hit& { return found.hits[found.of_ray[i]]; },
        [&](std::size_t i, const std::optional<Hit>& hit) {
            if (hit)
                found.hits[found.of_ray[i]] = *hit;
            else
                found.of_ray[i] = no_index;
        });
    return found;
}

std::vector<bool> Tracer::any(std::span<const Ray> rays) const {
    std::vector<bool> hits(rays.size());
    each_block(rays, [&](PacketIntersector& search, const SearchScene& scene, std::size_t begin,
                         std::span<const Ray> block) {
        const LaneMask met = search.any(scene, block);
        for (std::size_t lane = 0; lane < block.size(); ++lane)
            hits[begin + lane] = (met >> lane & 1) != 0;
    });
    return hits;
}

std::vector<Hit> Tracer::Scene::merged_hits(const Ray& ray,
                                            std::span<const Crossing> crossings) const {
    std::vector<Crossing> sorted(crossings.begin(), crossings.end());
    std::sort(sorted.begin(), sorted.end(),
              [](const Crossing& a, const Crossing& b) { return a.before(b); });
    std::vector<Hit> at(sorted.size());
    SurfaceInteraction several = evaluation();
    for (std::size_t k = 0; k < sorted.size(); ++k) several.add(sorted[k], at[k]);
    several.finish();
    std::vector<BoundaryHit> border_hits;
    border_hits.reserve(sorted.size());
    for (std::size_t k = 0; k < sorted.size(); ++k)
        border_hits.push_back(boundary_hit(model, sorted[k], std::move(at[k]), ray.direction));
    return merged(std::move(border_hits), model, ray.direction);
}

std::vector<std::vector<Hit>> Tracer::all(std::span<const Ray> rays) const {
    std::vector<std::vector<Hit>> hits(rays.size());
    each_block(rays, [&](PacketIntersector& search, const SearchScene& scene, std::size_t begin,
                         std::span<const Ray> block) {
        const std::span<const std::vector<Crossing>> found = search.all(scene, block);
        for (std::size_t lane = 0; lane < block.size(); ++lane)
            hits[begin + lane] = scene_->merged_hits(block[lane], found[lane]);
    });
    return hits;
}

std::span<const Box3> Tracer::boxes() const {
    return hidden_ ? hidden_->boxes : scene_->sub_patch_boxes;
}

const TracerStatistics& Tracer::statistics() const {
    return scene_->statistics;
}
const Box3& Tracer::bounds() const {
    return scene_->material;
}

double Tracer::seam_width(std::uint32_t trim_curve) const {
    return scene_->model.seam_gaps[trim_curve].width;
}

} // namespace keiko
