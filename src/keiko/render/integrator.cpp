#include "keiko/render/integrator.h"

#include "keiko/fog/transmittance.h"
#include "keiko/luminance/flake_kernel.h"
#include "keiko/luminance/gloss_kernel.h"
#include "keiko/luminance/photometry.h"
#include "keiko/rig/luminance_along.h"
#include "keiko/rig/mirrored_luminance.h"
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

Integrator::Integrator(const PictureScene& scene, const PictureOptions& options)
    : scene_(scene), options_(options), lights_(scene.rig, scene.occluders, scene.tracer) {
    std::vector<Material> known;
    for (const Material& material : scene.materials) {
        const auto found = std::find(known.begin(), known.end(), material);
        paint_of_face_.push_back(static_cast<std::uint32_t>(found - known.begin()));
        if (found != known.end()) continue;
        known.push_back(material);
        paints_.emplace_back(material);
    }
}

ShaftShadows Integrator::shaft_shadows(std::span<const Path> paths,
                                       std::span<const std::optional<Hit>> hits) const {
    std::vector<Segment> legs;
    if (scene_.rig.medium && scene_.occluders)
        for (std::size_t i = 0; i < paths.size(); ++i)
            legs.push_back({paths[i].ray.origin, end_of(paths[i].ray, hits[i])});
    return {scene_.rig, scene_.occluders, scene_.tracer, legs};
}

std::vector<EyeSample> Integrator::follow(std::span<const Ray> eye_rays) const {
    std::vector<EyeSample> samples(eye_rays.size());
    std::vector<Path> paths;
    for (std::size_t i = 0; i < eye_rays.size(); ++i) paths.push_back({eye_rays[i], i, Rgb(1)});

    for (int depth = 0; !paths.empty(); ++depth) {
        std::vector<Ray> rays;
        rays.reserve(paths.size());
        for (const Path& path : paths) rays.push_back(path.ray);
        const std::vector<std::optional<Hit>> hits = scene_.tracer.nearest(rays);

        const ShaftShadows shadows = shaft_shadows(paths, hits);
        const VisibleFrom shafts = shadows.visible();
        std::vector<Path> mirrored;
        for (std::size_t i = 0; i < paths.size(); ++i) {
            EyeSample& sample = samples[paths[i].sample];
            if (auto next = advance(std::move(paths[i]), hits[i], depth, shafts, sample))
                mirrored.push_back(std::move(*next));
        }
        paths = std::move(mirrored);
    }
    return samples;
}

std::optional<Integrator::Path> Integrator::advance(Path path, const std::optional<Hit>& hit,
                                                    int depth, const VisibleFrom& shafts,
                                                    EyeSample& sample) const {
    if (depth == 0) {
        sample.hit = hit;
        if (hit) sample.paint = paint_of_face_[hit->face];
    } else {
        if (depth == 1) note_mirrored(path.ray, hit, sample);
        see_lamps(path, hit ? hit->t : path.ray.t_max, shafts, sample);
    }
    if (!hit) {
        pass_medium(path, end_of(path.ray, hit), shafts, sample);
        sample.luminance +=
            path.weight * (depth == 0 ? scene_.background : even_luminance(scene_.rig.ambient));
        return std::nullopt;
    }
    sample.paths.count(*hit);
    pass_medium(path, hit->position, shafts, sample);

    const double towards = hit->normal.dot(path.ray.direction);
    const Vec3 normal = towards > 0 ? -hit->normal : hit->normal;
    const double length = path.ray.direction.length(), cosine = std::abs(towards) / length;
    sample.luminance += path.weight * base_luminance(*hit, normal, path.ray.direction / -length);

    path.weight *= paint(*hit).mirrored(cosine);
    if (depth >= options_.max_depth || !(max_channel(path.weight) >= options_.min_weight))
        return std::nullopt;
    path.ray = mirror_ray(path.ray, *hit);
    return path;
}

void Integrator::note_mirrored(const Ray& ray, const std::optional<Hit>& hit,
                               EyeSample& sample) const {
    if (hit) sample.mirrored_face = hit->face;
    const auto plane = nearest_c_plane(scene_.rig, ray.origin, ray.direction);
    if (plane && !(hit && hit->t < plane->at.t)) sample.c_plane = Vec2(plane->at.u, plane->at.v);
}

void Integrator::see_lamps(Path& path, double t_max, const VisibleFrom& shafts,
                           EyeSample& sample) const {
    const Ray& ray = path.ray;
    const auto plane = nearest_c_plane(scene_.rig, ray.origin, ray.direction);
    if (!plane) return;
    const MirroredLight lamps =
        mirrored_luminance(scene_.rig, ray.origin, ray.direction, ray.differentials, t_max);
    if (lamps.coverage == 0) return;
    Rgb seen = lamps.luminance;
    if (scene_.rig.medium) {
        const Segment leg{ray.origin, ray.origin + ray.direction * plane->at.t};
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

Rgb Integrator::base_luminance(const Hit& hit, const Vec3& normal, const Vec3& eye) const {
    const LightRig& rig = scene_.rig;
    const Paint& paint = this->paint(hit);
    const double cosine = normal.dot(eye);
    const LitPoint lit = lights_.at(hit.position, normal, hit.root);
    Rgb sum;
    if (const Rgb inner = paint.base().inner_reflectance(cosine); inner != Rgb(0))
        sum += lambert_luminance(inner, lit.illuminance(TubeModel::picture, &paint.base()));
    if (rig.ambient != Rgb(0))
        sum += even_luminance(rig.ambient) *
               (paint.base().base_reflectance_diffuse(cosine) + paint.gloss_albedo(cosine));
    if (paint.gloss()) sum += lit.glossy(GlossKernel(*paint.gloss(), normal, eye));
    if (paint.flakes()) sum += lit.glossy(FlakeKernel(*paint.flakes(), normal, eye));
    return sum;
}

} // namespace keiko
