#include "keiko/render/integrator.h"

#include "keiko/fog/transmittance.h"
#include "keiko/luminance/photometry.h"
#include "keiko/rig/luminance_along.h"
#include "keiko/trace/mirroring.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {

namespace {

/// mm: where a ray that meets nothing ends, for the medium in between.
constexpr double far_away = 1e6;

Vec3 end_of(const Ray& ray, const Hit* hit) {
    return hit ? hit->position : ray.origin + ray.direction.normalized() * far_away;
}

const Hit* found(const std::optional<Hit>& hit) {
    return hit ? &*hit : nullptr;
}

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

Integrator::Integrator(const PictureScene& scene, const PictureOptions& options,
                       const std::optional<Vec3>& eye, const Job& job)
    : scene_(scene),
      options_(options),
      planes_(scene.rig),
      lights_(scene.rig, scene.occluders, scene.tracer),
      tubes_(scene.occluders ? options.tubes : TubeModel::preview),
      tells_illuminance_(std::count(options.aovs.begin(), options.aovs.end(), Aov::illuminance)),
      refines_(options.edge_samples > 1) {
    std::vector<Material> known;
    for (const Material& material : scene.materials) {
        const auto found = std::find(known.begin(), known.end(), material);
        paint_of_face_.push_back(static_cast<std::uint32_t>(found - known.begin()));
        if (found != known.end()) continue;
        known.push_back(material);
        paints_.emplace_back(material);
    }
    if (eye) pencils_ = shaft_pencils(scene.rig, scene.occluders, scene.tracer, *eye, job);
}

ShaftShadows Integrator::shaft_shadows(std::span<const Ray> rays,
                                       std::span<const std::optional<Hit>> hits, int depth) const {
    std::vector<Segment> legs;
    if (scene_.rig.medium && scene_.occluders)
        for (std::size_t i = 0; i < rays.size(); ++i)
            legs.push_back({rays[i].origin, end_of(rays[i], found(hits[i]))});
    const auto pencils =
        depth == 0 ? std::span(pencils_) : std::span<const std::optional<ShadowPencil>>();
    return {scene_.rig, scene_.occluders, scene_.tracer, legs, pencils};
}

EyeView Integrator::follow(std::span<const Ray> eye_rays) const {
    EyeView view = this->view(std::vector<Ray>(eye_rays.begin(), eye_rays.end()));
    for (const LitSpot& spot : view.spots)
        add_light(spot, light_on(spot), view.samples[spot.sample]);
    return view;
}

EyeView Integrator::view(std::vector<Ray> eye_rays) const {
    EyeView view;
    view.samples.resize(eye_rays.size());
    Wave wave;
    wave.paths.reserve(eye_rays.size());
    for (std::size_t i = 0; i < eye_rays.size(); ++i) wave.paths.push_back({i, Rgb(1)});
    wave.rays = std::move(eye_rays);
    follow(std::move(wave), nullptr, view);
    return view;
}

EyeSample Integrator::unseen() const {
    EyeSample unseen;
    unseen.luminance = scene_.background;
    return unseen;
}

EyeView Integrator::view(EyeGrid grid) const {
    EyeView view;
    MirroredGrid mirrored(grid.width, grid.height);
    view.samples.assign(mirrored.size(), unseen());
    Wave wave;
    wave.rays = std::move(grid.rays);
    wave.paths.reserve(grid.places.size());
    for (const std::size_t place : grid.places) {
        view.samples[place].luminance = Rgb();
        wave.paths.push_back({place, Rgb(1)});
    }
    follow(std::move(wave), &mirrored, view);
    return view;
}

void Integrator::follow(Wave wave, MirroredGrid* grid, EyeView& view) const {
    Wave beside; // rays that only tell how the images of neighbours are bent
    const PixelMirror no_mirror;
    for (int depth = 0; !wave.rays.empty(); ++depth) {
        std::vector<std::optional<Hit>> hits = scene_.tracer.nearest(wave.rays);
        if (depth == 1 && grid) fill(*grid, {&wave, &beside}, view.samples);
        const std::vector<PixelMirror> mirrors =
            depth == 0 ? std::vector<PixelMirror>()
                       : mirrors_of(wave, hits, depth == 1 ? grid : nullptr);
        const ShaftShadows shadows = shaft_shadows(wave.rays, hits, depth);
        const VisibleFrom shafts = shadows.visible();
        const std::vector<Incidence> incidences = this->incidences(wave.rays, hits, depth);
        Wave mirrored;
        mirrored.reserve(wave.rays.size());
        if (depth == 0 && grid) beside.reserve(grid->most_at_border());
        Mirroring mirroring(mirror_kernel_);
        const std::size_t spots = view.spots.size();
        for (std::size_t i = 0; i < wave.rays.size(); ++i) {
            const Met met{wave.rays[i], found(hits[i]), depth == 0 ? no_mirror : mirrors[i],
                          incidences[i]};
            Path path = wave.paths[i];
            if (!advance(path, met, depth, shafts, view)) continue;
            const bool ends = grid && !refines_ && grid->at_border(path.sample);
            mirroring.add(met.ray, *met.hit, (ends ? beside : mirrored).add(path));
        }
        mirroring.finish();
        sort_by_sample(std::span(view.spots).subspan(spots), view.samples.size());
        if (depth == 0) view.hits = std::move(hits);
        wave = std::move(mirrored);
    }
}

std::vector<Integrator::Incidence> Integrator::incidences(std::span<const Ray> rays,
                                                          std::span<const std::optional<Hit>> hits,
                                                          int depth) const {
    std::vector<Incidence> all(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!hits[i]) continue;
        const Vec3& direction = rays[i].direction;
        const double cosine = std::abs(hits[i]->normal.dot(direction)) / direction.length();
        all[i].cosine = cosine;
        if (depth < options_.max_depth)
            all[i].mirrored = paints_[paint_of_face_[hits[i]->face]].mirrored(cosine);
    }
    return all;
}

void Integrator::fill(MirroredGrid& grid, std::initializer_list<const Wave*> waves,
                      std::span<const EyeSample> samples) {
    for (const Wave* wave : waves)
        for (std::size_t i = 0; i < wave->rays.size(); ++i) {
            const std::size_t place = wave->paths[i].sample;
            grid.set(place, wave->rays[i], place_of(samples[place]));
        }
    grid.join();
}

std::vector<PixelMirror> Integrator::mirrors_of(const Wave& wave,
                                                std::span<const std::optional<Hit>> hits,
                                                const MirroredGrid* grid) const {
    std::vector<PixelMirror> mirrors(wave.rays.size());
    const auto t_max = [&](std::size_t i) { return hits[i] ? hits[i]->t : wave.rays[i].t_max; };
    if (!grid) {
        for (std::size_t i = 0; i < wave.rays.size(); ++i)
            mirrors[i] = mirror_of(planes_, wave.rays[i], {}, t_max(i), refines_);
        return mirrors;
    }
    constexpr auto none = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> ray_at(grid->size(), none);
    for (std::size_t i = 0; i < wave.rays.size(); ++i) ray_at[wave.paths[i].sample] = i;
    MirroredStripes stripes(planes_, *grid, stripe_kernels_, refines_);
    for (std::size_t place = 0; place < ray_at.size(); ++place)
        if (const std::size_t i = ray_at[place]; i != none)
            stripes.find(place, wave.rays[i], t_max(i), mirrors[i]);
    return mirrors;
}

bool Integrator::advance(Path& path, const Met& met, int depth, const VisibleFrom& shafts,
                         EyeView& view) const {
    EyeSample& sample = view.samples[path.sample];
    note(path, met, depth, shafts, sample);
    pass_medium(path, met, shafts, sample);
    if (!met.hit) {
        sample.luminance +=
            path.weight * (depth == 0 ? scene_.background : even_luminance(scene_.rig.ambient));
        return false;
    }
    sample.paths.count(*met.hit);
    const std::uint32_t paint = paint_of_face_[met.hit->face];
    if (takes_light(paint, depth)) {
        view.spots.push_back(spot_at(path, met, depth));
        sample.lit = true;
        sample.luminance += path.weight * ambient_luminance(view.spots.back());
    }
    if (depth == 0) sample.cosine = met.incidence.cosine;
    if (depth >= options_.max_depth) return false;
    path.weight *= met.incidence.mirrored;
    return max_channel(path.weight) >= options_.min_weight;
}

/// What a ray from the eye meets first, and what its mirrored ones pass.
void Integrator::note(Path& path, const Met& met, int depth, const VisibleFrom& shafts,
                      EyeSample& sample) const {
    if (depth == 0) {
        sample.hit = met.hit;
        sample.paint = met.hit ? paint_of_face_[met.hit->face] : 0;
        return;
    }
    if (depth == 1) note_mirrored(met, sample);
    sample.torn = sample.torn || met.mirror.torn;
    add_lamps(path, met, shafts, sample);
}

/// Whether light on a paint, beside what it mirrors, is seen or asked for.
bool Integrator::takes_light(std::uint32_t paint, int depth) const {
    return paints_[paint].takes_light() || (depth == 0 && tells_illuminance_);
}

/// Its side that the path comes from.
LitSpot Integrator::spot_at(const Path& path, const Met& met, int depth) const {
    const Hit& hit = *met.hit;
    const Vec3& direction = met.ray.direction;
    const Vec3 normal = hit.normal.dot(direction) > 0 ? -hit.normal : hit.normal;
    const Vec3 eye = direction / -direction.length();
    return {path.sample, depth, {hit.position, normal, paint_of_face_[hit.face]},
            hit.root,    eye,   path.weight};
}

void Integrator::note_mirrored(const Met& met, EyeSample& sample) {
    if (met.hit) sample.mirrored_face = met.hit->face;
    const auto& plane = met.mirror.plane;
    if (!plane || (met.hit && met.hit->t < plane->at.t)) return;
    sample.c_plane = Vec2(plane->at.u, plane->at.v);
    sample.across_lamps = plane->at.v / plane->frame->pitch;
}

void Integrator::add_lamps(Path& path, const Met& met, const VisibleFrom& shafts,
                           EyeSample& sample) const {
    const MirroredLight& lamps = met.mirror.lamps;
    if (lamps.coverage == 0) return;
    const Ray& ray = met.ray;
    Rgb seen = lamps.luminance;
    if (scene_.rig.medium) {
        const auto& plane = met.mirror.plane;
        const Segment leg{ray.origin, plane ? ray.at(plane->at.t) : ray.origin};
        seen *= transmittance(*scene_.rig.medium, leg);
        seen += lamps.coverage *
                luminance_along(scene_.rig, leg, Rgb(0), shafts, picture_scattering_tolerance);
    }
    sample.luminance += path.weight * seen;
    path.weight *= 1 - lamps.coverage;
}

void Integrator::pass_medium(Path& path, const Met& met, const VisibleFrom& shafts,
                             EyeSample& sample) const {
    if (!scene_.rig.medium) return;
    const Segment leg{met.ray.origin, end_of(met.ray, met.hit)};
    sample.luminance += path.weight * luminance_along(scene_.rig, leg, Rgb(0), shafts,
                                                      picture_scattering_tolerance);
    path.weight *= transmittance(*scene_.rig.medium, leg);
}

} // namespace keiko
