// What lights bring to the shading points that the paths of an Integrator meet.
#include "keiko/light/luminance/flake_kernel.h"
#include "keiko/light/luminance/gloss_kernel.h"
#include "keiko/light/luminance/photometry.h"
#include "keiko/render/shading/integrator.h"
#include "keiko/render/shading/point_lighting.h"

namespace keiko {

std::vector<LightVisibility> Integrator::light_visibility(const ShadingPoint& point,
                                                          std::span<const LightId> lights) const {
    return lights_.light_visibility(point.place.position, point.place.normal, point.root, lights,
                                    tubes_);
}

std::vector<DirectLight> Integrator::direct_light(const ShadingPoint& point,
                                                  std::span<const LightId> lights,
                                                  std::vector<LightVisibility> seen) const {
    const Paint& paint = paints_[point.place.paint];
    const Vec3& normal = point.place.normal;
    const PointLighting lit(scene_.rig, point.place.position, normal, tubes_, lights,
                            std::move(seen));
    std::vector<DirectLight> brought(lights.size());
    const auto each = [&](const std::vector<Rgb>& values, const auto& add) {
        for (std::size_t i = 0; i < values.size(); ++i) add(brought[i], values[i]);
    };
    const ClearCoat* coat = paint.base().passes_all() ? nullptr : &paint.base();
    const bool scatters = paint.base().inner_reflectance(normal.dot(point.eye)) != Rgb(0);
    if (scatters)
        each(lit.illuminance_by_light(coat),
             [](DirectLight& light, const Rgb& lx) { light.illuminance = lx; });
    if (point.depth == 0 && tells_illuminance_) {
        if (!scatters || coat)
            each(lit.illuminance_by_light(),
                 [](DirectLight& light, const Rgb& lx) { light.incident = keiko::luminance(lx); });
        else
            for (DirectLight& light : brought) light.incident = keiko::luminance(light.illuminance);
    }
    const auto add_lobe = [](DirectLight& light, const Rgb& sent) { light.lobes += sent; };
    if (paint.gloss())
        each(lit.glossy_by_light(GlossKernel(*paint.gloss(), normal, point.eye)), add_lobe);
    if (paint.flakes())
        each(lit.glossy_by_light(FlakeKernel(*paint.flakes(), normal, point.eye)), add_lobe);
    return brought;
}

DirectLight Integrator::direct_light(const ShadingPoint& point) const {
    DirectLight sum;
    for (const DirectLight& of_light :
         direct_light(point, lights(), light_visibility(point, lights())))
        sum += of_light;
    return sum;
}

Rgb Integrator::luminance(const ShadingPoint& point, const DirectLight& light) const {
    const ClearCoat& base = paints_[point.place.paint].base();
    return lambert_luminance(base.inner_reflectance(point.place.normal.dot(point.eye)),
                             light.illuminance) +
           light.lobes;
}

void Integrator::add_light(const ShadingPoint& point, const DirectLight& light,
                           PixelSample& sample) const {
    sample.luminance += point.weight * luminance(point, light);
    if (point.depth == 0) sample.illuminance = light.incident;
}

Rgb Integrator::ambient_luminance(const ShadingPoint& point) const {
    if (scene_.rig.ambient == Rgb(0)) return {};
    const Paint& paint = paints_[point.place.paint];
    const double cosine = point.place.normal.dot(point.eye);
    return even_luminance(scene_.rig.ambient) *
           (paint.base().base_reflectance_diffuse(cosine) + paint.gloss_albedo(cosine));
}

} // namespace keiko
