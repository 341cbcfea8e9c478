#include "keiko/workflow/scattering_depth.h"

#include "keiko/light/rig/luminance_along.h"

namespace keiko {

double scatterings_past_body(const Scene& scene, const LightRig& rig, const Vec3& eye) {
    return scatterings_by_way_of(rig, scene.tracer.bounds().center(), eye);
}

} // namespace keiko
