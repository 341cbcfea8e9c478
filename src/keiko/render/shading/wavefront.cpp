// Propagation of the paths of an Integrator from mirror to mirror, many at once.
#include "keiko/intersect/hit/reflect_ray.h"
#include "keiko/intersect/kernels/prefetch.h"
#include "keiko/render/shading/integrator.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <span>
#include <utility>

namespace keiko {

namespace {

/// Makes the last row of a grid the second of one of `size` places. Its first is unused, as
/// everything is done there except determining the bend of the images below it.
template <class T>
void take_over_row(std::vector<T>& places, std::size_t width, std::size_t size, const T& blank) {
    std::copy(places.end() - static_cast<std::ptrdiff_t>(width), places.end(),
              places.begin() + static_cast<std::ptrdiff_t>(width));
    std::fill_n(places.begin(), width, blank);
    places.resize(2 * width);
    places.resize(size, blank);
}

} // namespace

void EyeBand::begin(const TileRays& grid, const PixelSample& unseen) {
    if (!grid.continues_above) {
        view.samples.assign(mirrors.grid.size(), unseen);
        return;
    }
    mirrors.grid.take_over_rows(grid.height);
    const auto width = static_cast<std::size_t>(grid.width);
    take_over_row(view.samples, width, mirrors.grid.size(), unseen);
    take_over_row(mirrors.ways, width, mirrors.grid.size(), {});
    above_ = std::exchange(mirrors.hits, {});
    std::move(view.hits.begin(), view.hits.end(), std::back_inserter(above_));
    view.hits.clear();
}

void EyeBand::announce(std::size_t place) const {
    prefetch(std::span(view.samples).subspan(place, 1));
    prefetch(std::span(mirrors.ways).subspan(place, 1));
    mirrors.grid.announce(place);
}

namespace {

/// Number of camera rays of a grid that are traced together with their reflected rays: few enough
/// for their data to stay in the processor's cache, enough to fill its vectors.
constexpr std::size_t rays_at_once = 256;
/// Number of places prefetched before they are written, since they are scattered over more memory
/// than the cache.
constexpr std::size_t places_ahead = 8;

/// Sorts shading points by sample; each of the `samples` samples has one at most.
void sort_by_sample(std::span<ShadingPoint> points, std::size_t samples) {
    const auto by_sample = [](const ShadingPoint& a, const ShadingPoint& b) {
        return a.sample < b.sample;
    };
    if (std::is_sorted(points.begin(), points.end(), by_sample)) return;
    std::vector<const ShadingPoint*> of_sample(samples);
    for (const ShadingPoint& point : points) of_sample[point.sample] = &point;
    std::vector<ShadingPoint> sorted;
    sorted.reserve(points.size());
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
    for (std::size_t i = 0; i < camera_rays.size(); ++i) wave.paths.push_back({i, Rgb(1)});
    wave.rays = std::move(camera_rays);
    follow(std::move(wave), 0, view);
    return view;
}

PixelSample Integrator::unseen() const {
    PixelSample unseen;
    unseen.luminance = scene_.background;
    return unseen;
}

SampleBatch Integrator::view(const TileRays& grid) const {
    EyeBand band(grid.width, grid.height);
    trace_tile(grid, band);
    return std::move(band.view);
}

void Integrator::trace_tile(const TileRays& grid, EyeBand& band) const {
    band.begin(grid, unseen());
    const std::span<const GridPlace> places = grid.places;
    // The visibility of the rays' segments from the lights is computed for all of them together.
    const std::size_t most = scene_.rig.medium ? places.size() : rays_at_once;
    for (std::size_t first = 0; first < places.size(); first += most)
        trace_primary(grid, places.subspan(first, std::min(most, places.size() - first)), band);
    sort_by_sample(band.view.points, band.view.samples.size());
    band.mirrors.grid.join();
    follow(shade_hits(grid, band.mirrors, band.view), 2, band.view);
}

void Integrator::trace_primary(const TileRays& grid, std::span<const GridPlace> places,
                               EyeBand& band) const {
    SampleBatch& view = band.view;
    ReflectedGrid& mirrors = band.mirrors.grid;
    const Rays rays = grid.rays(places);
    FirstHits hits = scene_.tracer.first_hits(rays);
    const VolumetricShadows shadows = volumetric_shadows(legs_of(rays, hits), 0);
    const VisibleFrom shafts = shadows.visible();
    const std::vector<FresnelTerm> incidences = this->incidences(rays, hits, 0);
    const PixelMirror no_mirror;
    RayQueue mirrored, beside; // beside: rays that only determine the bend of the neighbours'
                               // images
    mirrored.reserve(rays.size()), beside.reserve(rays.size());
    ReflectionBatch mirroring(mirror_kernel_);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (i + places_ahead < places.size()) band.announce(places[i + places_ahead].number);
        PixelSample& sample = view.samples[places[i].number];
        const Hit* hit = hits[i];
        sample.luminance = Rgb();
        if (keeps_hits_) sample.hit = hit;
        const bool ends = !refines_ && grid.at_border(places[i]);
        RayQueue& wave = ends ? beside : mirrored;
        PathState& path = wave.paths.emplace_back(PathState{places[i].number, Rgb(1)});
        if (!shade(path, {rays[i], hit, no_mirror, incidences[i]}, 0, shafts, view)) {
            wave.paths.pop_back();
            continue;
        }
        mirrors.set_begin(path.sample, {hit->position, hit->normal, sample.paint});
        mirroring.add(rays[i], *hit, wave.rays.emplace_back());
    }
    mirroring.finish();
    if (keeps_hits_) view.hits.push_back(std::move(hits.hits));
    set_rays(beside, mirrors), set_rays(mirrored, mirrors);
    trace_reflections(mirrored, band.mirrors);
}

void Integrator::set_rays(const RayQueue& wave, ReflectedGrid& grid) {
    for (std::size_t i = 0; i < wave.rays.size(); ++i) grid.set(wave.paths[i].sample, wave.rays[i]);
}

void Integrator::trace_reflections(const RayQueue& mirrored, ReflectionBuffer& mirrors) const {
    FirstHits hits = scene_.tracer.first_hits(mirrored.rays, mirrored_detail());
    for (std::size_t i = 0; i < mirrored.paths.size(); ++i) {
        const PathState& path = mirrored.paths[i];
        mirrors.ways[path.sample] = {true, hits[i], path.weight};
    }
    mirrors.hits.push_back(std::move(hits.hits));
}

Integrator::RayQueue Integrator::shade_hits(const TileRays& grid, const ReflectionBuffer& mirrors,
                                            SampleBatch& view) const {
    const VolumetricShadows shadows = volumetric_shadows(legs_of(mirrors), 1);
    const VisibleFrom shafts = shadows.visible();
    LampReflections stripes(planes_, mirrors.grid, stripe_kernels_, refines_);
    std::vector<PathState> further;
    Ray ray;
    const auto row = static_cast<std::size_t>(grid.width);
    const std::size_t end = mirrors.ways.size() - (grid.continues_below ? row : 0);
    for (std::size_t place = grid.continues_above ? row : 0; place < end; ++place) {
        const auto& [goes_on, hit, weight] = mirrors.ways[place];
        if (!goes_on) continue;
        PixelMirror mirror;
        stripes.find(place, hit ? hit->t : std::numeric_limits<double>::infinity(), mirror);
        if (hit || scene_.rig.medium) ray = mirrors.grid.ray(place); // others do not need it
        const FresnelTerm incidence = hit ? this->incidence(ray, *hit, 1) : FresnelTerm();
        PathState path{place, weight};
        if (shade(path, {ray, hit, mirror, incidence}, 1, shafts, view)) further.push_back(path);
    }
    return mirrored_again(further, mirrors);
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
    ReflectionBatch mirroring(mirror_kernel_);
    for (std::size_t i = 0; i < wave.rays.size(); ++i) {
        const Ray& ray = wave.rays[i];
        const Hit* hit = hits[i];
        PathState path = wave.paths[i];
        PixelMirror mirror;
        if (depth == 0)
            view.samples[path.sample].hit = hit;
        else
            mirror = mirror_of(planes_, ray, {}, hit ? hit->t : ray.t_max, refines_);
        if (shade(path, {ray, hit, mirror, incidences[i]}, depth, shafts, view))
            mirroring.add(ray, *hit, mirrored.add(path));
    }
    mirroring.finish();
    return mirrored;
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
    return {scene_.rig, scene_.occluders, scene_.tracer, legs, pencils};
}

Integrator::FresnelTerm Integrator::incidence(const Ray& ray, const Hit& hit, int depth) const {
    // It is not needed there, and the hit may have no normal.
    if (depth > 0 && depth >= options_.max_depth) return {};
    const double cosine = std::abs(hit.normal.dot(ray.direction)) / ray.direction.length();
    FresnelTerm incidence{cosine, {}};
    if (depth < options_.max_depth)
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
