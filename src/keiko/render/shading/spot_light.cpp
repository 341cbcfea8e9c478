// What lights bring to the spots that the paths of an Integrator meet.
#include "keiko/light/luminance/flake_kernel.h"
#include "keiko/light/luminance/gloss_kernel.h"
#include "keiko/light/luminance/photometry.h"
#include "keiko/render/shading/integrator.h"
#include "keiko/render/shading/lit_point.h"

namespace keiko {

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
    const ClearCoat* coat = paint.base().passes_all() ? nullptr : &paint.base();
    const bool scatters = paint.base().inner_reflectance(normal.dot(spot.eye)) != Rgb(0);
    if (scatters)
        each(lit.illuminance_by_light(coat),
             [](SpotLight& light, const Rgb& lx) { light.illuminance = lx; });
    if (spot.depth == 0 && tells_illuminance_) {
        if (!scatters || coat)
            each(lit.illuminance_by_light(),
                 [](SpotLight& light, const Rgb& lx) { light.incident = keiko::luminance(lx); });
        else
            for (SpotLight& light : brought) light.incident = keiko::luminance(light.illuminance);
    }
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
