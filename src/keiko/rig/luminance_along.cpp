#include "keiko/rig/luminance_along.h"

#include "keiko/fog/single_scattering.h"
#include "keiko/fog/transmittance.h"
#include "keiko/spotlight/beam_intensity.h"
#include "keiko/spotlight/beam_volume.h"

namespace keiko {
namespace {

/// Answers what the medium scatters of one source into the eye ray.
struct Inscatter {
    const Medium& medium;
    const Segment& eye_ray;
    const VisibleFrom& visible_from;

    /// A lamp's own glow in the medium is left out: it is spread so wide that `ambient` stands
    /// for it.
    Rgb operator()(const CPlane&) const { return {}; }

    /// So does it for what the sky sheds into the medium.
    Rgb operator()(const Sun&) const { return {}; }

    Rgb operator()(const Spotlight& light) const {
        if (!light.shaft) return {};
        IntervalSet lit = in_beam(light, eye_ray);
        if (lit.empty()) return {};
        if (visible_from) lit = lit.intersect(visible_from(light.position, eye_ray));
        return scattered_light(medium, eye_ray, lit, {light.position, BeamIntensity(light)});
    }
};

} // namespace

Rgb luminance_along(const LightRig& rig, const Segment& eye_ray, const Rgb& surface,
                    const VisibleFrom& visible_from) {
    if (!rig.medium) return surface;
    const double length = (eye_ray.b - eye_ray.a).length();
    Rgb sum = surface * transmittance(*rig.medium, length) + ambient_inscatter(*rig.medium, length);
    const Inscatter inscatter{*rig.medium, eye_ray, visible_from};
    for (const LightSource& source : rig.sources) sum += std::visit(inscatter, source);
    return sum;
}

} // namespace keiko
