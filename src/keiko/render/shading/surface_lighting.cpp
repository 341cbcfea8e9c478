// The light that an Integrator finds at a shading point: of lamps, of other surfaces and of the
// surroundings.
#include "keiko/light/luminance/flake_kernel.h"
#include "keiko/light/luminance/gloss_kernel.h"
#include "keiko/light/luminance/photometry.h"
#include "keiko/radiosity/reflected_light.h"
#include "keiko/render/shading/integrator.h"

#include <utility>

namespace keiko {
namespace {

double doubled_azimuth(const ShadingPoint& point) {
    return doubled_azimuth_cosine(point.place.normal, point.eye, point.along);
}

DirectLight sum_of(std::span<const DirectLight> lights) {
    DirectLight sum;
    for (const DirectLight& light : lights) sum += light;
    return sum;
}

} // namespace

std::vector<LightVisibility> Integrator::light_visibility(const ShadingPoint& point,
                                                          std::span<const LightId> lights) const {
    return lights_.light_visibility(point.place.position, point.place.normal, point.root, lights,
                                    tubes_);
}

std::vector<DirectLight> Integrator::direct_light(const ShadingPoint& point,
                                                  std::span<const LightId> lights,
                                                  std::vector<LightVisibility> seen) const {
    // Of the material, so that light between places with dark spots of a map is theirs too.
    const Paint& paint = paints_[point.place.paint];
    const Vec3& normal = point.place.normal;
    const PointLighting lit(rig_, point.place.position, normal, tubes_, lights, std::move(seen));
    std::vector<DirectLight> brought(lights.size());
    const std::vector<Rgb> left = left_on_the_way(point, lights);
    const auto each = [&](const std::vector<Rgb>& values, const auto& add) {
        for (std::size_t i = 0; i < values.size(); ++i)
            add(brought[i], left.empty() ? values[i] : values[i] * left[i]);
    };
    const ClearCoat* coat = paint.base().passes_all() ? nullptr : &paint.base();
    const bool scatters = paint.base().inner_reflectance(normal.dot(point.eye)) != Rgb(0);
    if (scatters)
        each(lit.illuminance_by_light(coat),
             [](DirectLight& light, const Rgb& lx) { light.illuminance = lx; });
    if (point.branch == 0 && tells_illuminance_) {
        if (!scatters || coat)
            each(lit.illuminance_by_light(),
                 [](DirectLight& light, const Rgb& lx) { light.incident = keiko::luminance(lx); });
        else
            for (DirectLight& light : brought) light.incident = keiko::luminance(light.illuminance);
    }
    const auto add_lobe = [&](const auto& kernel, const Rgb& share) {
        each(lit.glossy_by_light(kernel, lights_, point.root),
             [&](DirectLight& light, const Rgb& sent) { light.lobes += sent * share; });
    };
    if (const auto& gloss = paint_of(point).gloss())
        add_lobe(GlossKernel(*gloss, normal, point.eye, point.along),
                 paint_of(point).gloss_share());
    if (paint.flakes()) add_lobe(FlakeKernel(*paint.flakes(), normal, point.eye), Rgb(1));
    return brought;
}

std::vector<Rgb> Integrator::left_on_the_way(const ShadingPoint& point,
                                             std::span<const LightId> lights) const {
    if (!dims_light()) return {};
    std::vector<Rgb> left(lights.size(), Rgb(1));
    const Vec3& place = point.place.position;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const auto& [source, lamp] = lights[i];
        if (glass_dims()) left[i] = glass_.left(rig_.sources[source], lamp, place, point.root);
        if (matter_dims()) left[i] *= matter_.left(rig_.sources[source], lamp, place);
    }
    return left;
}

DirectLight Integrator::direct_light(const ShadingPoint& point,
                                     std::span<const LightId> lights) const {
    return sum_of(direct_light(point, lights, light_visibility(point, lights)));
}

DirectLight Integrator::unoccluded_light(const ShadingPoint& point,
                                         std::span<const LightId> lights) const {
    const LightVisibility whole{IntervalSet::whole()};
    return sum_of(direct_light(point, lights, std::vector(lights.size(), whole)));
}

Rgb Integrator::luminance(const ShadingPoint& point, const DirectLight& light) const {
    const Paint& paint = paint_of(point);
    const double cosine = point.place.normal.dot(point.eye);
    const Rgb base = paint.base().inner_reflectance(cosine) *
                     paint.passed_by_brushed(cosine, doubled_azimuth(point));
    return lambert_luminance(base, light.illuminance) + light.lobes;
}

Rgb Integrator::luminance(const ShadingPoint& point, const Ray& mirrored) const {
    const Paint& paint = paint_of(point);
    const Rgb share = paint.mirrored(point.place.normal.dot(point.eye));
    Rgb sum;
    if (share != Rgb(0)) sum += share * follow_mirrored(Rays{mirrored}).samples.front().luminance;
    if (paint.takes_light())
        sum += ambient_luminance(point, ambient_illuminance(point)) +
               luminance(point, direct_light(point));
    return sum;
}

void Integrator::add_light(const ShadingPoint& point, const DirectLight& light,
                           PixelSample& sample) const {
    const DirectLight all = light + point.known;
    sample.luminance += point.weight * luminance(point, all);
    if (point.branch != 0) return;
    sample.illuminance = all.incident;
    if (tells_illuminance_ && scene_.reflected)
        sample.illuminance += keiko::luminance(point.ambient);
}

Rgb Integrator::ambient_illuminance(const ShadingPoint& point) const {
    if (!scene_.reflected) return scene_.rig.ambient;
    const Vec3& normal = point.place.normal;
    const LightPoint place{point.place.position, normal, point.root};
    if (options_.gather_rays > 0) return scene_.reflected->gathered(place, options_.gather_rays);
    constexpr int rays_without_elements = 256;
    const auto light = scene_.reflected->on_surface(point.root, normal);
    return light ? *light : scene_.reflected->gathered(place, rays_without_elements);
}

Rgb Integrator::ambient_luminance(const ShadingPoint& point, const Rgb& ambient) const {
    const bool is_surrounded = environment() && environment()->spec().lights;
    if (ambient == Rgb(0) && !is_surrounded) return {};
    const Paint& paint = paint_of(point);
    const double cosine = point.place.normal.dot(point.eye), doubled = doubled_azimuth(point);
    const Rgb base =
        paint.base().base_reflectance_diffuse(cosine) * paint.passed_by_brushed(cosine, doubled);
    const Rgb lobes = paint.gloss_albedo(cosine, doubled);
    Rgb sum = even_luminance(ambient) * (is_surrounded ? base : base + lobes);
    if (!is_surrounded) return sum;
    sum += even_luminance(environment()->irradiance(point.place.normal)) * base;
    if (lobes == Rgb(0)) return sum;
    const Vec3 mirrored = reflect(-point.eye, point.place.normal);
    return sum + environment()->blurred(mirrored, paint.lobe_width()) * lobes;
}

} // namespace keiko
