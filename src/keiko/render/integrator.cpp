#include "keiko/render/integrator.h"

#include "keiko/fog/transmittance.h"
#include "keiko/luminance/flake_kernel.h"
#include "keiko/luminance/gloss_kernel.h"
#include "keiko/luminance/photometry.h"
#include "keiko/rig/luminance_along.h"
#include "keiko/trace/mirror_ray.h"

#include <algorithm>
#include <cmath>

namespace keiko {

namespace {

/// mm: where a ray that meets nothing ends, for the medium in between.
constexpr double far_away = 1e6;

Vec3 end_of(const Ray& ray, const std::optional<Hit>& hit) {
    return hit ? hit->position : ray.origin + ray.direction.normalized() * far_away;
}

} // namespace

Integrator::Integrator(const PictureScene& scene, const PictureOptions& options,
                       const std::optional<Vec3>& eye, const Job& job)
    : scene_(scene),
      options_(options),
      planes_(scene.rig),
      lights_(scene.rig, scene.occluders, scene.tracer),
      tubes_(scene.occluders ? options.tubes : TubeModel::preview),
      tells_illuminance_(std::count(options.aovs.begin(), options.aovs.end(), Aov::illuminance)) {
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

ShaftShadows Integrator::shaft_shadows(std::span<const Path> paths,
                                       std::span<const std::optional<Hit>> hits, int depth) const {
    std::vector<Segment> legs;
    if (scene_.rig.medium && scene_.occluders)
        for (std::size_t i = 0; i < paths.size(); ++i)
            legs.push_back({paths[i].ray.origin, end_of(paths[i].ray, hits[i])});
    const auto pencils =
        depth == 0 ? std::span(pencils_) : std::span<const std::optional<ShadowPencil>>();
    return {scene_.rig, scene_.occluders, scene_.tracer, legs, pencils};
}

std::vector<EyeSample> Integrator::follow(std::span<const Ray> eye_rays) const {
    EyeView view = this->view(eye_rays);
    for (const LitSpot& spot : view.spots)
        add_light(spot, light_on(spot), view.samples[spot.sample]);
    return std::move(view.samples);
}

EyeView Integrator::view(std::span<const Ray> eye_rays, int grid_width) const {
    EyeView view;
    view.samples.resize(eye_rays.size());
    std::vector<Path> paths;
    for (std::size_t i = 0; i < eye_rays.size(); ++i) paths.push_back({eye_rays[i], i, Rgb(1)});

    for (int depth = 0; !paths.empty(); ++depth) {
        std::vector<Ray> rays;
        rays.reserve(paths.size());
        for (const Path& path : paths) rays.push_back(path.ray);
        const std::vector<std::optional<Hit>> hits = scene_.tracer.nearest(rays);
        const std::vector<PixelMirror> mirrors =
            depth == 0 ? std::vector<PixelMirror>(paths.size())
                       : mirrors_of(paths, hits, depth == 1 ? grid_width : 0, view.spots);

        const ShaftShadows shadows = shaft_shadows(paths, hits, depth);
        const VisibleFrom shafts = shadows.visible();
        std::vector<Path> mirrored;
        for (std::size_t i = 0; i < paths.size(); ++i)
            if (auto next =
                    advance(std::move(paths[i]), {hits[i], mirrors[i]}, depth, shafts, view))
                mirrored.push_back(std::move(*next));
        paths = std::move(mirrored);
    }
    return view;
}

std::vector<PixelMirror> Integrator::mirrors_of(std::span<const Path> paths,
                                                std::span<const std::optional<Hit>> hits,
                                                int grid_width,
                                                std::span<const LitSpot> spots) const {
    std::optional<MirroredGrid> grid;
    if (grid_width > 0) grid.emplace(grid_width, spots);
    if (grid)
        for (const Path& path : paths) grid->set(path.sample, path.ray);
    std::vector<PixelMirror> mirrors;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        const Ray& ray = paths[i].ray;
        const double t_max = hits[i] ? hits[i]->t : ray.t_max;
        mirrors.push_back(
            mirror_of(planes_, ray, grid ? grid->pixel(paths[i].sample) : std::nullopt, t_max));
    }
    return mirrors;
}

std::optional<Integrator::Path> Integrator::advance(Path path, const Met& met, int depth,
                                                    const VisibleFrom& shafts,
                                                    EyeView& view) const {
    const std::optional<Hit>& hit = met.hit;
    EyeSample& sample = view.samples[path.sample];
    note(path, met, depth, shafts, sample);
    pass_medium(path, end_of(path.ray, hit), shafts, sample);
    if (!hit) {
        sample.luminance +=
            path.weight * (depth == 0 ? scene_.background : even_luminance(scene_.rig.ambient));
        return std::nullopt;
    }
    sample.paths.count(*hit);
    const LitSpot spot = spot_at(path, *hit, depth);
    sample.luminance += path.weight * ambient_luminance(spot);
    view.spots.push_back(spot);

    const double cosine =
        std::abs(hit->normal.dot(path.ray.direction)) / path.ray.direction.length();
    path.weight *= paints_[paint_of_face_[hit->face]].mirrored(cosine);
    if (depth >= options_.max_depth || !(max_channel(path.weight) >= options_.min_weight))
        return std::nullopt;
    path.ray = mirror_ray(path.ray, *hit);
    return path;
}

/// What a ray from the eye meets first, and what its mirrored ones pass.
void Integrator::note(Path& path, const Met& met, int depth, const VisibleFrom& shafts,
                      EyeSample& sample) const {
    if (depth == 0) {
        sample.hit = met.hit;
        sample.paint = met.hit ? paint_of_face_[met.hit->face] : 0;
        return;
    }
    if (depth == 1) note_mirrored(path.ray, met.hit, sample);
    sample.torn = sample.torn || met.mirror.torn;
    add_lamps(path, met.mirror.lamps, shafts, sample);
}

/// Its side that the path comes from.
LitSpot Integrator::spot_at(const Path& path, const Hit& hit, int depth) const {
    const Vec3 normal = hit.normal.dot(path.ray.direction) > 0 ? -hit.normal : hit.normal;
    const Vec3 eye = path.ray.direction / -path.ray.direction.length();
    return {path.sample, depth, {hit.position, normal, paint_of_face_[hit.face]},
            hit.root,    eye,   path.weight};
}

void Integrator::note_mirrored(const Ray& ray, const std::optional<Hit>& hit,
                               EyeSample& sample) const {
    if (hit) sample.mirrored_face = hit->face;
    const auto plane = planes_.nearest(ray.origin, ray.direction);
    if (plane && !(hit && hit->t < plane->at.t)) sample.c_plane = Vec2(plane->at.u, plane->at.v);
}

void Integrator::add_lamps(Path& path, const MirroredLight& lamps, const VisibleFrom& shafts,
                           EyeSample& sample) const {
    if (lamps.coverage == 0) return;
    const Ray& ray = path.ray;
    Rgb seen = lamps.luminance;
    if (scene_.rig.medium) {
        const auto plane = planes_.nearest(ray.origin, ray.direction);
        const Segment leg{ray.origin, plane ? ray.at(plane->at.t) : ray.origin};
        seen *= transmittance(*scene_.rig.medium, leg);
        seen += lamps.coverage *
                luminance_along(scene_.rig, leg, Rgb(0), shafts, picture_scattering_tolerance);
    }
    sample.luminance += path.weight * seen;
    path.weight *= 1 - lamps.coverage;
}

void Integrator::pass_medium(Path& path, const Vec3& end, const VisibleFrom& shafts,
                             EyeSample& sample) const {
    if (!scene_.rig.medium) return;
    const Segment leg{path.ray.origin, end};
    sample.luminance += path.weight * luminance_along(scene_.rig, leg, Rgb(0), shafts,
                                                      picture_scattering_tolerance);
    path.weight *= transmittance(*scene_.rig.medium, leg);
}

std::vector<SeenLight> Integrator::seen_from(const LitSpot& spot,
                                             std::span<const RigLight> lights) const {
    return lights_.seen_from(spot.place.position, spot.place.normal, spot.root, lights, tubes_);
}

std::vector<SpotLight> Integrator::light_on(const LitSpot& spot, std::span<const RigLight> lights,
                                            std::vector<SeenLight> seen) const {
    const Paint& paint = paints_[spot.place.paint];
    const Vec3& normal = spot.place.normal;
    const LitPoint lit(scene_.rig, spot.place.position, normal, tubes_, lights, std::move(seen));
    std::vector<SpotLight> brought(lights.size());
    const auto each = [&](const std::vector<Rgb>& values, const auto& add) {
        for (std::size_t i = 0; i < values.size(); ++i) add(brought[i], values[i]);
    };
    if (paint.base().inner_reflectance(normal.dot(spot.eye)) != Rgb(0))
        each(lit.illuminance_by_light(&paint.base()),
             [](SpotLight& light, const Rgb& lx) { light.illuminance = lx; });
    if (spot.depth == 0 && tells_illuminance_)
        each(lit.illuminance_by_light(),
             [](SpotLight& light, const Rgb& lx) { light.incident = keiko::luminance(lx); });
    const auto add_lobe = [](SpotLight& light, const Rgb& sent) { light.lobes += sent; };
    if (paint.gloss())
        each(lit.glossy_by_light(GlossKernel(*paint.gloss(), normal, spot.eye)), add_lobe);
    if (paint.flakes())
        each(lit.glossy_by_light(FlakeKernel(*paint.flakes(), normal, spot.eye)), add_lobe);
    return brought;
}

SpotLight Integrator::light_on(const LitSpot& spot) const {
    SpotLight sum;
    for (const SpotLight& of_light : light_on(spot, lights(), seen_from(spot, lights())))
        sum += of_light;
    return sum;
}

Rgb Integrator::luminance(const LitSpot& spot, const SpotLight& light) const {
    const ClearCoat& base = paints_[spot.place.paint].base();
    return lambert_luminance(base.inner_reflectance(spot.place.normal.dot(spot.eye)),
                             light.illuminance) +
           light.lobes;
}

void Integrator::add_light(const LitSpot& spot, const SpotLight& light, EyeSample& sample) const {
    sample.luminance += spot.weight * luminance(spot, light);
    if (spot.depth == 0) sample.illuminance = light.incident;
}

Rgb Integrator::ambient_luminance(const LitSpot& spot) const {
    if (scene_.rig.ambient == Rgb(0)) return {};
    const Paint& paint = paints_[spot.place.paint];
    const double cosine = spot.place.normal.dot(spot.eye);
    return even_luminance(scene_.rig.ambient) *
           (paint.base().base_reflectance_diffuse(cosine) + paint.gloss_albedo(cosine));
}

} // namespace keiko
