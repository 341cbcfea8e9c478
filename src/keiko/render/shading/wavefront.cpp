// Propagation of the paths of an Integrator from mirror to mirror, many at once.
#include "keiko/intersect/hit/reflect_ray.h"
#include "keiko/render/shading/integrator.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <span>
#include <tuple>
#include <utility>

namespace keiko {

namespace {

/// Number of camera rays of a grid that are traced together with their reflected rays: few enough
/// for their data to stay in the processor's cache, enough to fill its vectors.
constexpr std::size_t rays_at_once = 256;

/// Sorts shading points by branch, then by sample; each of the `samples` samples has one of a
/// branch at most.
void sort_by_sample(std::span<ShadingPoint> points, std::size_t samples) {
    const auto before = [](const ShadingPoint& a, const ShadingPoint& b) {
        return std::tie(a.branch, a.sample) < std::tie(b.branch, b.sample);
    };
    if (std::is_sorted(points.begin(), points.end(), before)) return;
    std::map<std::uint64_t, std::vector<const ShadingPoint*>> of_branch;
    for (const ShadingPoint& point : points) {
        std::vector<const ShadingPoint*>& of_sample = of_branch[point.branch];
        of_sample.resize(samples);
        of_sample[point.sample] = &point;
    }
    std::vector<ShadingPoint> sorted;
    sorted.reserve(points.size());
    for (const auto& [branch, of_sample] : of_branch)
        for (const ShadingPoint* point : of_sample)
            if (point) sorted.push_back(*point);
    std::copy(sorted.begin(), sorted.end(), points.begin());
}

} // namespace

SampleBatch Integrator::view(Rays camera_rays) const {
    SampleBatch view;
    view.samples.resize(camera_rays.size());
    RayQueue wave;
    wave.paths.reserve(camera_rays.size());
    const std::vector<const Paint*> around = glass_around(camera_rays);
    for (std::size_t i = 0; i < camera_rays.size(); ++i)
        wave.paths.push_back({.sample = i, .weight = Rgb(1), .inside = around[i]});
    wave.rays = std::move(camera_rays);
    follow(std::move(wave), 0, view);
    return view;
}

SampleBatch Integrator::follow_mirrored(Rays rays) const {
    SampleBatch view;
    view.samples.resize(rays.size());
    RayQueue wave;
    wave.reserve(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i)
        wave.paths.push_back({.sample = i, .weight = Rgb(1), .straight = false});
    wave.rays = std::move(rays);
    follow(std::move(wave), 1, view);
    return lit(std::move(view));
}

PixelSample Integrator::unseen() const {
    PixelSample unseen;
    unseen.luminance = scene_.background;
    return unseen;
}

SampleBatch Integrator::view(const TileRays& grid) const {
    ReflectionBuffer mirrors(grid.width, grid.height);
    SampleBatch view;
    view.samples.assign(mirrors.grid.size(), unseen());
    const std::span<const GridPlace> places = grid.places;
    // The visibility of the rays' segments from the lights is computed for all of them together.
    const std::size_t most = scene_.rig.medium ? places.size() : rays_at_once;
    RayQueue passed;
    for (std::size_t first = 0; first < places.size(); first += most)
        trace_primary(grid, places.subspan(first, std::min(most, places.size() - first)), view,
                      mirrors, passed);
    sort_by_sample(view.points, view.samples.size());
    mirrors.grid.join();
    follow(shade_hits(mirrors, view), 2, view);
    follow(std::move(passed), 1, view);
    return view;
}

void Integrator::trace_primary(const TileRays& grid, std::span<const GridPlace> places,
                               SampleBatch& view, ReflectionBuffer& mirrors,
                               RayQueue& passed) const {
    const Rays rays = grid.rays(places);
    FirstHits hits = scene_.tracer.first_hits(rays);
    const std::vector<Vec3> unbent = bend(rays, hits);
    const VolumetricShadows shadows = volumetric_shadows(legs_of(rays, hits), 0);
    const VisibleFrom shafts = shadows.visible();
    const std::vector<FresnelTerm> incidences = this->incidences(rays, hits, 0);
    const PixelMirror no_mirror;
    const std::vector<const Paint*> around = glass_around(rays);
    RayQueue mirrored;
    mirrored.reserve(rays.size());
    ReflectionBatch mirroring(mirror_kernel_);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        PixelSample& sample = view.samples[places[i].number];
        const Hit* hit = hits[i];
        sample.luminance = Rgb();
        if (keeps_hits_) sample.hit = hit;
        if (!unbent.empty()) sample.unbent = unbent[i];
        const PathState path{.sample = places[i].number, .weight = Rgb(1), .inside = around[i]};
        const Onward onward = shade(path, {rays[i], hit, no_mirror, incidences[i]}, shafts, view);
        if (onward.passed) passed.add_passed(*onward.passed, rays[i], *hit, onward.eta);
        if (!onward.mirrored) continue;
        mirrors.grid.set_begin(path.sample, {hit->position, hit->normal, sample.paint});
        mirroring.add(rays[i], *hit, mirrored.add(*onward.mirrored));
    }
    mirroring.finish();
    if (keeps_hits_) view.hits.push_back(std::move(hits.hits));
    trace_reflections(mirrored, mirrors);
}

void Integrator::trace_reflections(const RayQueue& mirrored, ReflectionBuffer& mirrors) const {
    FirstHits hits = scene_.tracer.first_hits(mirrored.rays, mirrored_detail());
    bend(mirrored.rays, hits);
    for (std::size_t i = 0; i < mirrored.paths.size(); ++i) {
        const PathState& path = mirrored.paths[i];
        mirrors.grid.set(path.sample, mirrored.rays[i]);
        mirrors.ways[path.sample] = {true, hits[i], path.weight};
    }
    mirrors.hits.push_back(std::move(hits.hits));
}

Integrator::RayQueue Integrator::shade_hits(const ReflectionBuffer& mirrors,
                                            SampleBatch& view) const {
    const VolumetricShadows shadows = volumetric_shadows(legs_of(mirrors), 1);
    const VisibleFrom shafts = shadows.visible();
    LampReflections stripes(planes_, mirrors.grid, stripe_kernels_, refines_);
    std::vector<PathState> further;
    RayQueue passed;
    Ray ray;
    for (std::size_t place = 0; place < mirrors.ways.size(); ++place) {
        const auto& [goes_on, hit, weight] = mirrors.ways[place];
        if (!goes_on) continue;
        PixelMirror mirror;
        stripes.find(place, hit ? hit->t : std::numeric_limits<double>::infinity(), mirror);
        const bool reads_ray =
            hit || scene_.rig.medium || has_matter() || !areas_.empty() || sees_beyond();
        if (reads_ray) ray = mirrors.grid.ray(place);
        const FresnelTerm incidence = hit ? this->incidence(ray, *hit, 1) : FresnelTerm();
        const Onward onward =
            shade(path_of(place, weight), {ray, hit, mirror, incidence}, shafts, view);
        if (onward.mirrored) further.push_back(*onward.mirrored);
        if (onward.passed) passed.add_passed(*onward.passed, ray, *hit, onward.eta);
    }
    RayQueue on = mirrored_again(further, mirrors);
    on.append(passed);
    return on;
}

Integrator::PathState Integrator::path_of(std::size_t place, const Rgb& weight) {
    return {.sample = place, .weight = weight, .branch = 1, .mirrors = 1, .straight = false};
}

Integrator::RayQueue Integrator::mirrored_again(std::span<const PathState> paths,
                                                const ReflectionBuffer& mirrors) const {
    RayQueue mirrored;
    mirrored.reserve(paths.size());
    Rays incoming;
    incoming.reserve(paths.size());
    ReflectionBatch mirroring(mirror_kernel_);
    for (const PathState& path : paths)
        mirroring.add(incoming.emplace_back(mirrors.grid.ray(path.sample)),
                      *mirrors.ways[path.sample].hit, mirrored.add(path));
    mirroring.finish();
    return mirrored;
}

void Integrator::follow(RayQueue wave, int depth, SampleBatch& view) const {
    for (; !wave.rays.empty(); ++depth) {
        FirstHits hits = scene_.tracer.first_hits(wave.rays);
        const std::vector<Vec3> unbent = bend(wave.rays, hits);
        if (depth == 0 && !unbent.empty())
            for (std::size_t i = 0; i < unbent.size(); ++i)
                view.samples[wave.paths[i].sample].unbent = unbent[i];
        const std::size_t points = view.points.size();
        wave = shade_hits(wave, hits, depth, view);
        sort_by_sample(std::span(view.points).subspan(points), view.samples.size());
        if (depth == 0) view.hits.push_back(std::move(hits.hits));
    }
}

Integrator::RayQueue Integrator::shade_hits(const RayQueue& wave, const FirstHits& hits, int depth,
                                            SampleBatch& view) const {
    const VolumetricShadows shadows = volumetric_shadows(legs_of(wave.rays, hits), depth);
    const VisibleFrom shafts = shadows.visible();
    const std::vector<FresnelTerm> incidences = this->incidences(wave.rays, hits, depth);
    RayQueue mirrored;
    mirrored.reserve(wave.rays.size());
    RayQueue passed;
    ReflectionBatch mirroring(mirror_kernel_);
    for (std::size_t i = 0; i < wave.rays.size(); ++i) {
        const Ray& ray = wave.rays[i];
        const Hit* hit = hits[i];
        const PathState& path = wave.paths[i];
        PixelMirror mirror;
        if (depth == 0)
            view.samples[path.sample].hit = hit;
        else if (!path.straight)
            mirror = mirror_of(planes_, ray, {}, hit ? hit->t : ray.t_max, refines_);
        const Onward onward = shade(path, {ray, hit, mirror, incidences[i]}, shafts, view);
        if (onward.mirrored) mirroring.add(ray, *hit, mirrored.add(*onward.mirrored));
        if (onward.passed) passed.add_passed(*onward.passed, ray, *hit, onward.eta);
    }
    mirroring.finish();
    mirrored.append(passed);
    return mirrored;
}

std::vector<Vec3> Integrator::bend(std::span<const Ray> rays, FirstHits& hits) const {
    if (!scene_.maps) return {};
    std::vector<Vec3> unbent(rays.size(), Vec3(0));
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!hits[i]) continue;
        unbent[i] = hits[i]->normal;
        maps_.bend(rays[i], hits.hits[hits.of_ray[i]]);
    }
    return unbent;
}

std::vector<Segment> Integrator::legs_of(std::span<const Ray> rays, const FirstHits& hits) const {
    std::vector<Segment> legs;
    if (!casts_shafts()) return legs;
    for (std::size_t i = 0; i < rays.size(); ++i) legs.push_back(leg_of(rays[i], hits[i]));
    return legs;
}

std::vector<Segment> Integrator::legs_of(const ReflectionBuffer& mirrors) const {
    std::vector<Segment> legs;
    if (!casts_shafts()) return legs;
    for (std::size_t place = 0; place < mirrors.ways.size(); ++place)
        if (mirrors.ways[place].goes_on)
            legs.push_back(leg_of(mirrors.grid.ray(place), mirrors.ways[place].hit));
    return legs;
}

VolumetricShadows Integrator::volumetric_shadows(std::span<const Segment> legs, int depth) const {
    const auto pencils =
        depth == 0 ? std::span(pencils_) : std::span<const std::optional<EpipolarShadows>>();
    return {scene_.rig, scene_.occluders, scene_.casting(), legs, pencils};
}

Integrator::FresnelTerm Integrator::incidence(const Ray& ray, const Hit& hit, int depth) const {
    // It is not needed there, and the hit may have no normal.
    if (depth > 0 && depth >= options_.max_depth && !glass_.any()) return {};
    const double cosine = std::abs(hit.normal.dot(ray.direction)) / ray.direction.length();
    FresnelTerm incidence{cosine, {}};
    if (depth < options_.max_depth || glass_.any())
        incidence.mirrored = paints_[paint_of_face_[hit.face]].mirrored(cosine);
    return incidence;
}

std::vector<Integrator::FresnelTerm> Integrator::incidences(std::span<const Ray> rays,
                                                            const FirstHits& hits,
                                                            int depth) const {
    std::vector<FresnelTerm> all(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i)
        if (const Hit* hit = hits[i]) all[i] = incidence(rays[i], *hit, depth);
    return all;
}

} // namespace keiko
