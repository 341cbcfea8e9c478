#include "keiko/render/shading/integrator.h"

#include "keiko/intersect/hit/local_surface.h"
#include "keiko/light/fog/transmittance.h"
#include "keiko/light/luminance/flake_kernel.h"
#include "keiko/light/luminance/gloss_kernel.h"
#include "keiko/light/luminance/photometry.h"
#include "keiko/light/rig/luminance_along.h"
#include "keiko/light/sky/sky_panels.h"
#include "keiko/radiosity/reflected_light.h"
#include "keiko/render/shading/texel_light.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

/// Branch of what the first surface mirrors.
constexpr std::uint64_t first_mirrored = 1;

/// True for a way that passes every surface that it meets: 2, 6, 14 ...
bool passes_alone(std::uint64_t branch) {
    return std::has_single_bit(branch + 2);
}

/// True if no lamp's light has an edge on a smooth surface.
bool lamps_are_smooth(const PictureScene& scene) {
    const auto is_row = [](const LightSource& source) {
        return std::holds_alternative<CPlane>(source);
    };
    return !scene.occluders && !scene.rig.medium &&
           std::all_of(scene.rig.sources.begin(), scene.rig.sources.end(), is_row);
}

/// Share of light that a way inside glass leaves.
Rgb left_inside(const Glass& glass, const Segment& way) {
    return transmittance(glass.absorption * (way.b - way.a).length());
}

} // namespace

Integrator::Integrator(const PictureScene& scene, const PictureOptions& options,
                       const std::optional<Vec3>& eye, const Job& job)
    : scene_(scene),
      options_(options),
      maps_(scene.maps, scene.materials),
      planes_(scene.rig),
      areas_(scene.rig),
      sky_(scene.rig),
      rig_(scene.rig),
      lights_(rig_, scene.occluders, scene.casting()),
      glass_(scene.tracer, scene.materials, scene.caustics.has_value()),
      matter_(scene.volumes, scene.texels),
      tubes_(scene.occluders ? options.tubes : TubeModel::preview),
      tells_illuminance_(std::count(options.aovs.begin(), options.aovs.end(), Aov::illuminance)),
      refines_(options.edge_samples > 1),
      keeps_hits_(refines_ || !options.aovs.empty()) {
    if (scene.volumes && scene.rig.medium)
        throw FieldError("volume", "stands in no fog: take either volumes or a rig with fog");
    if (scene.texels && scene.rig.medium)
        throw FieldError("texels", "stand in no fog: take either texels or a rig with fog");
    std::vector<Material> known;
    for (const Material& material : scene.materials) {
        const auto found = std::find(known.begin(), known.end(), material);
        paint_of_face_.push_back(static_cast<std::uint32_t>(found - known.begin()));
        if (found != known.end()) continue;
        known.push_back(material);
        paints_.emplace_back(material);
        mirrors_alone_ = mirrors_alone_ && !paints_.back().takes_light() && !material.glass &&
                         material.maps.empty();
    }
    const bool smooth = lamps_are_smooth(scene);
    for (std::size_t i = 0; i < lights().size(); ++i)
        if (smooth || is_open_sky(lights()[i]))
            smooth_lights_.push_back(lights()[i]);
        else
            interpolated_lights_.push_back(i);
    if (scene.caustics)
        caustics_.emplace(scene.tracer, scene.materials, rig_, *scene.caustics, job);
    if (scene.volumes) volumes_.emplace(*scene.volumes, scene.rig, stops_of_light(), job);
    if (scene.texels)
        texels_.emplace(*scene.texels, light_on_texels(), even_luminance(scene.rig.ambient), job);
    if (eye) pencils_ = shaft_pencils(scene.rig, scene.occluders, scene.casting(), *eye, job);
}

Segment Integrator::leg_of(const Ray& ray, const Hit* hit) {
    return {ray.origin,
            hit ? hit->position : ray.origin + ray.direction.normalized() * sky_distance};
}

SampleBatch Integrator::follow(std::span<const Ray> camera_rays) const {
    return lit(this->view(Rays(camera_rays.begin(), camera_rays.end())));
}

SampleBatch Integrator::lit(SampleBatch view) const {
    for (const ShadingPoint& point : view.points)
        add_light(point, direct_light(point), view.samples[point.sample]);
    return view;
}

Integrator::Onward Integrator::shade(PathState path, const PathVertex& met,
                                     const VisibleFrom& shafts, SampleBatch& view) const {
    PixelSample& sample = view.samples[path.sample];
    record_aovs(path, met, sample);
    add_lights(path, met, shafts, sample);
    if (path.inside)
        path.weight *= left_inside(*path.inside->glass(), leg_of(met.ray, met.hit));
    else {
        pass_matter(path, met, sample);
        pass_medium(path, met, shafts, sample);
    }
    if (!met.hit) {
        sample.luminance += path.weight * beyond(path, met.ray);
        return {};
    }
    sample.paths.count(*met.hit);
    const std::uint32_t paint = paint_of_face_[met.hit->face];
    std::shared_ptr<const MappedPaint> mapped;
    if (maps_.has(met.hit->face)) mapped = maps_.paint(paints_[paint], met.ray, *met.hit);
    if (maps_.shines(met.ray, *met.hit))
        sample.luminance += path.weight * (mapped ? mapped->paint : paints_[paint]).emitted();
    if (takes_light(paint, path.branch)) {
        view.points.push_back(shading_point_at(path, met));
        view.points.back().mapped = mapped;
        if (caustics_) view.points.back().known = caustic_light(view.points.back(), met);
        sample.lit = true;
        ShadingPoint& point = view.points.back();
        point.ambient = ambient_illuminance(point);
        sample.luminance += path.weight * ambient_luminance(point, point.ambient);
    }
    if (path.branch == 0) sample.cosine = met.incidence.cosine;
    return onward(path, met, mapped.get());
}

Rgb Integrator::beyond(const PathState& path, const Ray& ray) const {
    const Rgb else_seen = behind_sky(path, ray);
    if (sky_.empty()) return else_seen;
    const MirroredLight sky = sky_.beyond(ray.origin, ray.direction, ray.differentials);
    return sky.luminance + else_seen * (1 - sky.coverage);
}

Rgb Integrator::behind_sky(const PathState& path, const Ray& ray) const {
    if (environment() && (environment()->spec().visible || !path.straight)) {
        const RayDifferentials spread = ray.differentials.value_or(RayDifferentials());
        return environment()->luminance(ray.direction, spread.direction_dx, spread.direction_dy);
    }
    return path.straight ? scene_.background : even_luminance(scene_.rig.ambient);
}

/// Records the first hit of a camera ray, and the hits of the rays that it sends on.
void Integrator::record_aovs(const PathState& path, const PathVertex& met,
                             PixelSample& sample) const {
    if (path.branch == 0) {
        sample.covered = met.hit != nullptr;
        sample.paint = met.hit ? paint_of_face_[met.hit->face] : 0;
        return;
    }
    if (path.branch == first_mirrored && keeps_hits_) note_mirrored(met, sample);
    if (passes_alone(path.branch) && keeps_hits_) note_behind(met, sample);
    sample.discontinuous = sample.discontinuous || met.mirror.discontinuous;
}

HitDetail Integrator::mirrored_detail() const {
    const bool ends =
        options_.max_depth <= 1 && !scene_.rig.medium && !has_matter() && mirrors_alone_;
    return ends ? HitDetail::face : HitDetail::all;
}

/// True if light on a paint, beside its reflections, is visible or requested.
bool Integrator::takes_light(std::uint32_t paint, std::uint64_t branch) const {
    return paints_[paint].takes_light() || (branch == 0 && tells_illuminance_);
}

/// Shading point on the side that the path comes from.
ShadingPoint Integrator::shading_point_at(const PathState& path, const PathVertex& met) const {
    const Hit& hit = *met.hit;
    const Vec3& direction = met.ray.direction;
    const Vec3 normal = hit.normal.dot(direction) > 0 ? -hit.normal : hit.normal;
    const Vec3 eye = direction / -direction.length();
    const std::uint32_t paint = paint_of_face_[hit.face];
    const ScratchDirection* scratches = paints_[paint].scratches();
    const Vec3 along =
        scratches ? direction_at(*scratches, hit.position, hit.dpdu, hit.dpdv) : Vec3(0);
    return {path.sample, path.branch, {hit.position, normal, paint}, hit.root, eye,
            path.weight, along};
}

DirectLight Integrator::caustic_light(const ShadingPoint& point, const PathVertex& met) const {
    const Hit& hit = *met.hit;
    SurfaceFootprint footprint{hit.instance,          hit.face,
                               hit.position,          point.place.normal,
                               hit.dpdu.normalized(), hit.dpdv.normalized()}; // 1 mm
    if (met.ray.differentials) {
        const RayDifferentials& d = *met.ray.differentials;
        footprint.dx = bounded(transfer(met.ray, hit, d.origin_dx, d.direction_dx));
        footprint.dy = bounded(transfer(met.ray, hit, d.origin_dy, d.direction_dy));
    }
    const ClearCoat& base = paints_[point.place.paint].base();
    const CausticLight light = caustics_->over(footprint, base.passes_all() ? nullptr : &base);
    return {light.entering, Rgb(), keiko::luminance(light.incident)};
}

void Integrator::note_behind(const PathVertex& met, PixelSample& sample) const {
    sample.behind.reset();
    if (met.hit)
        sample.behind = {met.hit->position, met.hit->normal, paint_of_face_[met.hit->face]};
}

void Integrator::note_mirrored(const PathVertex& met, PixelSample& sample) {
    if (met.hit) sample.mirrored_face = met.hit->face;
    const auto& plane = met.mirror.plane;
    if (!plane || (met.hit && met.hit->t < plane->at.t)) return;
    sample.c_plane = Vec2(plane->at.u, plane->at.v);
    sample.across_lamps = plane->at.v / plane->frame->pitch;
}

/// Adds the rows of lamps that a reflected ray meets, and the panels and spheres that any ray does.
void Integrator::add_lights(PathState& path, const PathVertex& met, const VisibleFrom& shafts,
                            PixelSample& sample) const {
    const Ray& ray = met.ray;
    const MirroredLight& rows = met.mirror.lamps; // none before the camera
    const auto add_rows = [&] { add_light_at(rows.t, rows, path, ray, shafts, sample); };
    if (areas_.empty()) return add_rows();
    bool rows_added = false;
    for (const RigAreas::Layer& layer : areas_.along(ray.origin, ray.direction, ray.differentials,
                                                     met.hit ? met.hit->t : ray.t_max)) {
        const AreaHit& hit = layer.hit;
        if (!rows_added && rows.t <= hit.t) add_rows(), rows_added = true;
        add_light_at(hit.t, {layer.luminance * hit.coverage, hit.coverage}, path, ray, shafts,
                     sample);
    }
    if (!rows_added) add_rows();
}

/// Adds lights at t of a ray, and takes what they cover from what is behind.
void Integrator::add_light_at(double t, const MirroredLight& light, PathState& path, const Ray& ray,
                              const VisibleFrom& shafts, PixelSample& sample) const {
    if (light.coverage == 0) return;
    Rgb seen = light.luminance;
    if (scene_.rig.medium) {
        const Segment leg{ray.origin, ray.at(t)};
        seen *= transmittance(*scene_.rig.medium, leg);
        seen += light.coverage *
                luminance_along(scene_.rig, leg, Rgb(0), shafts, picture_scattering_tolerance);
    }
    if (has_matter() && !path.inside) {
        const FrontToBack before = matter_before(ray, ray.at(t));
        seen = before.light * light.coverage + seen * (1 - before.opacity);
    }
    sample.luminance += path.weight * seen;
    path.weight *= 1 - light.coverage;
}

StopOfLight Integrator::stops_of_light() const {
    if (!scene_.occluders) return {};
    return [this](const Vec3& from, const Vec3& direction) {
        Ray way;
        way.origin = from, way.direction = direction;
        const auto hit = scene_.casting().nearest(way);
        return hit ? hit->t : std::numeric_limits<double>::infinity();
    };
}

LightsAt Integrator::light_on_texels() const {
    const GlassLoss straight(scene_.tracer, scene_.materials);
    const MatterLoss matter(scene_.occluders ? scene_.volumes : nullptr, nullptr);
    return [this, straight, matter](const Vec3& place) {
        const LossBeforeTexels loss{glass_dims() ? &straight : nullptr, matter};
        return arriving_lights(rig_, lights_, loss, tubes_, place);
    };
}

FrontToBack Integrator::matter_before(const Ray& ray, const Vec3& end) const {
    FrontToBack sum;
    Vec3 begin = ray.origin;
    const auto add_volumes = [&](const Vec3& until) {
        if (volumes_ && begin != until) sum.add(volumes_->along({begin, until}));
        begin = until;
    };
    if (texels_) {
        std::optional<RayDifferentials> spread = ray.differentials;
        const double length = ray.direction.length();
        if (spread) spread->direction_dx /= length, spread->direction_dy /= length;
        for (const TexelLayer& layer : texels_->along({ray.origin, end}, spread)) {
            add_volumes(ray.origin + ray.direction * (layer.begin / length));
            sum.add(layer.sum);
        }
    }
    add_volumes(end);
    return sum;
}

void Integrator::pass_matter(PathState& path, const PathVertex& met, PixelSample& sample) const {
    if (!has_matter()) return;
    const Vec3& eye = met.ray.origin;
    const double reach = std::max(scene_.volumes ? scene_.volumes->reach_from(eye) : 0,
                                  scene_.texels ? scene_.texels->reach_from(eye) : 0);
    const Vec3 end = met.hit ? met.hit->position : eye + met.ray.direction.normalized() * reach;
    const FrontToBack before = matter_before(met.ray, end);
    sample.luminance += path.weight * before.light;
    path.weight *= 1 - before.opacity;
}

void Integrator::pass_medium(PathState& path, const PathVertex& met, const VisibleFrom& shafts,
                             PixelSample& sample) const {
    if (!scene_.rig.medium) return;
    const Segment leg = leg_of(met.ray, met.hit);
    sample.luminance += path.weight * luminance_along(scene_.rig, leg, Rgb(0), shafts,
                                                      picture_scattering_tolerance);
    path.weight *= transmittance(*scene_.rig.medium, leg);
}

} // namespace keiko
