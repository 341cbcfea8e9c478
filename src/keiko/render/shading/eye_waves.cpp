// How the paths of an Integrator go on from mirror to mirror, many at once.
#include "keiko/intersect/hit/mirroring.h"
#include "keiko/render/shading/integrator.h"

#include <algorithm>
#include <limits>

namespace keiko {

namespace {

/// Eye rays of a grid that are followed together up to what their mirrored ones meet: few enough
/// for all that is known of them to stay near the processor, enough to fill its vectors.
constexpr std::size_t rays_at_once = 256;
/// What is written of places is fetched before, for they are strewn over more memory than that.
constexpr std::size_t places_ahead = 8;

/// Spots at most one of which is of each sample, of which there are so many.
void sort_by_sample(std::span<LitSpot> spots, std::size_t samples) {
    const auto by_sample = [](const LitSpot& a, const LitSpot& b) { return a.sample < b.sample; };
    if (std::is_sorted(spots.begin(), spots.end(), by_sample)) return;
    std::vector<const LitSpot*> of_sample(samples);
    for (const LitSpot& spot : spots) of_sample[spot.sample] = &spot;
    std::vector<LitSpot> sorted;
    sorted.reserve(spots.size());
    for (const LitSpot* spot : of_sample)
        if (spot) sorted.push_back(*spot);
    std::copy(sorted.begin(), sorted.end(), spots.begin());
}

} // namespace

EyeView Integrator::view(Rays eye_rays) const {
    EyeView view;
    view.samples.resize(eye_rays.size());
    Wave wave;
    wave.paths.reserve(eye_rays.size());
    for (std::size_t i = 0; i < eye_rays.size(); ++i) wave.paths.push_back({i, Rgb(1)});
    wave.rays = std::move(eye_rays);
    follow(std::move(wave), 0, view);
    return view;
}

EyeSample Integrator::unseen() const {
    EyeSample unseen;
    unseen.luminance = scene_.background;
    return unseen;
}

EyeView Integrator::view(const EyeGrid& grid) const {
    EyeBand band(grid.width, grid.height);
    look_down(grid, band);
    return std::move(band.view);
}

void Integrator::look_down(const EyeGrid& grid, EyeBand& band) const {
    band.begin(grid, unseen());
    const std::span<const GridPlace> places = grid.places;
    // What lights see of the ways of rays is found for all of them together.
    const std::size_t most = scene_.rig.medium ? places.size() : rays_at_once;
    for (std::size_t first = 0; first < places.size(); first += most)
        look(grid, places.subspan(first, std::min(most, places.size() - first)), band);
    sort_by_sample(band.view.spots, band.view.samples.size());
    band.mirrors.grid.join();
    follow(meet(grid, band.mirrors, band.view), 2, band.view);
}

void Integrator::look(const EyeGrid& grid, std::span<const GridPlace> places, EyeBand& band) const {
    EyeView& view = band.view;
    MirroredGrid& mirrors = band.mirrors.grid;
    const Rays rays = grid.rays(places);
    FirstHits hits = scene_.tracer.first_hits(rays);
    const ShaftShadows shadows = shaft_shadows(legs_of(rays, hits), 0);
    const VisibleFrom shafts = shadows.visible();
    const std::vector<Incidence> incidences = this->incidences(rays, hits, 0);
    const PixelMirror no_mirror;
    Wave mirrored, beside; // beside: rays that only tell how the images of neighbours are bent
    mirrored.reserve(rays.size()), beside.reserve(rays.size());
    Mirroring mirroring(mirror_kernel_);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (i + places_ahead < places.size()) band.announce(places[i + places_ahead].number);
        EyeSample& sample = view.samples[places[i].number];
        const Hit* hit = hits[i];
        sample.luminance = Rgb();
        if (keeps_hits_) sample.hit = hit;
        const bool ends = !refines_ && grid.at_border(places[i]);
        Wave& wave = ends ? beside : mirrored;
        Path& path = wave.paths.emplace_back(Path{places[i].number, Rgb(1)});
        if (!advance(path, {rays[i], hit, no_mirror, incidences[i]}, 0, shafts, view)) {
            wave.paths.pop_back();
            continue;
        }
        mirrors.set_begin(path.sample, {hit->position, hit->normal, sample.paint});
        mirroring.add(rays[i], *hit, wave.rays.emplace_back());
    }
    mirroring.finish();
    if (keeps_hits_) view.hits.push_back(std::move(hits.hits));
    set_rays(beside, mirrors), set_rays(mirrored, mirrors);
    find_ways(mirrored, band.mirrors);
}

void Integrator::set_rays(const Wave& wave, MirroredGrid& grid) {
    for (std::size_t i = 0; i < wave.rays.size(); ++i) grid.set(wave.paths[i].sample, wave.rays[i]);
}

void Integrator::find_ways(const Wave& mirrored, FirstMirrors& mirrors) const {
    FirstHits hits = scene_.tracer.first_hits(mirrored.rays, mirrored_detail());
    for (std::size_t i = 0; i < mirrored.paths.size(); ++i) {
        const Path& path = mirrored.paths[i];
        mirrors.ways[path.sample] = {true, hits[i], path.weight};
    }
    mirrors.hits.push_back(std::move(hits.hits));
}

Integrator::Wave Integrator::meet(const EyeGrid& grid, const FirstMirrors& mirrors,
                                  EyeView& view) const {
    const ShaftShadows shadows = shaft_shadows(legs_of(mirrors), 1);
    const VisibleFrom shafts = shadows.visible();
    MirroredStripes stripes(planes_, mirrors.grid, stripe_kernels_, refines_);
    std::vector<Path> further;
    Ray ray;
    const auto row = static_cast<std::size_t>(grid.width);
    const std::size_t end = mirrors.ways.size() - (grid.continues_below ? row : 0);
    for (std::size_t place = grid.continues_above ? row : 0; place < end; ++place) {
        const auto& [goes_on, hit, weight] = mirrors.ways[place];
        if (!goes_on) continue;
        PixelMirror mirror;
        stripes.find(place, hit ? hit->t : std::numeric_limits<double>::infinity(), mirror);
        if (hit || scene_.rig.medium) ray = mirrors.grid.ray(place); // others ask for nothing of it
        const Incidence incidence = hit ? this->incidence(ray, *hit, 1) : Incidence();
        Path path{place, weight};
        if (advance(path, {ray, hit, mirror, incidence}, 1, shafts, view)) further.push_back(path);
    }
    return mirrored_again(further, mirrors);
}

Integrator::Wave Integrator::mirrored_again(std::span<const Path> paths,
                                            const FirstMirrors& mirrors) const {
    Wave mirrored;
    mirrored.reserve(paths.size());
    Rays incoming;
    incoming.reserve(paths.size());
    Mirroring mirroring(mirror_kernel_);
    for (const Path& path : paths)
        mirroring.add(incoming.emplace_back(mirrors.grid.ray(path.sample)),
                      *mirrors.ways[path.sample].hit, mirrored.add(path));
    mirroring.finish();
    return mirrored;
}

void Integrator::follow(Wave wave, int depth, EyeView& view) const {
    for (; !wave.rays.empty(); ++depth) {
        FirstHits hits = scene_.tracer.first_hits(wave.rays);
        const std::size_t spots = view.spots.size();
        wave = meet(wave, hits, depth, view);
        sort_by_sample(std::span(view.spots).subspan(spots), view.samples.size());
        if (depth == 0) view.hits.push_back(std::move(hits.hits));
    }
}

Integrator::Wave Integrator::meet(const Wave& wave, const FirstHits& hits, int depth,
                                  EyeView& view) const {
    const ShaftShadows shadows = shaft_shadows(legs_of(wave.rays, hits), depth);
    const VisibleFrom shafts = shadows.visible();
    const std::vector<Incidence> incidences = this->incidences(wave.rays, hits, depth);
    Wave mirrored;
    mirrored.reserve(wave.rays.size());
    Mirroring mirroring(mirror_kernel_);
    for (std::size_t i = 0; i < wave.rays.size(); ++i) {
        const Ray& ray = wave.rays[i];
        const Hit* hit = hits[i];
        Path path = wave.paths[i];
        PixelMirror mirror;
        if (depth == 0)
            view.samples[path.sample].hit = hit;
        else
            mirror = mirror_of(planes_, ray, {}, hit ? hit->t : ray.t_max, refines_);
        if (advance(path, {ray, hit, mirror, incidences[i]}, depth, shafts, view))
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

std::vector<Segment> Integrator::legs_of(const FirstMirrors& mirrors) const {
    std::vector<Segment> legs;
    if (!casts_shafts()) return legs;
    for (std::size_t place = 0; place < mirrors.ways.size(); ++place)
        if (mirrors.ways[place].goes_on)
            legs.push_back(leg_of(mirrors.grid.ray(place), mirrors.ways[place].hit));
    return legs;
}

ShaftShadows Integrator::shaft_shadows(std::span<const Segment> legs, int depth) const {
    const auto pencils =
        depth == 0 ? std::span(pencils_) : std::span<const std::optional<ShadowPencil>>();
    return {scene_.rig, scene_.occluders, scene_.tracer, legs, pencils};
}

Integrator::Incidence Integrator::incidence(const Ray& ray, const Hit& hit, int depth) const {
    // Asked for by no one there, and the hit may have no normal.
    if (depth > 0 && depth >= options_.max_depth) return {};
    const double cosine = std::abs(hit.normal.dot(ray.direction)) / ray.direction.length();
    Incidence incidence{cosine, {}};
    if (depth < options_.max_depth)
        incidence.mirrored = paints_[paint_of_face_[hit.face]].mirrored(cosine);
    return incidence;
}

std::vector<Integrator::Incidence> Integrator::incidences(std::span<const Ray> rays,
                                                          const FirstHits& hits, int depth) const {
    std::vector<Incidence> all(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i)
        if (const Hit* hit = hits[i]) all[i] = incidence(rays[i], *hit, depth);
    return all;
}

} // namespace keiko
