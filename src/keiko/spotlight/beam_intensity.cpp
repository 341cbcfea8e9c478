#include "keiko/spotlight/beam_intensity.h"

#include "keiko/base/units.h"
#include "keiko/luminance/photometry.h"

#include <cmath>
#include <numbers>

namespace keiko {

double rim_versine(const Spotlight& light) {
    const double sine = std::sin(degrees_to_radians(light.half_angle) / 2);
    return 2 * sine * sine;
}

double relative_intensity(const Spotlight& light, double versine) {
    const double rim = rim_versine(light);
    if (!(versine <= rim)) return 0;
    const double soft = rim > 0 ? 1 - versine / rim : 1; // (cos theta - cos g) / (1 - cos g)
    switch (light.edge) {
        case BeamEdge::sharp:
            return 1;
        case BeamEdge::soft:
            return soft;
        case BeamEdge::mixed:
            return (1 - light.q) * soft + light.q;
    }
    return 0;
}

Rgb intensity_towards(const Spotlight& light, const Vec3& point) {
    const Vec3 beam = point - light.position;
    const double distance = beam.length();
    if (!(distance > 0)) return {};
    return light.intensity * relative_intensity(light, versine(beam / distance, beam_axis(light)));
}

Rgb luminous_flux(const Spotlight& light) {
    const double cone = 2 * std::numbers::pi * rim_versine(light);
    switch (light.edge) {
        case BeamEdge::sharp:
            return light.intensity * cone;
        case BeamEdge::soft:
            return light.intensity * (cone / 2);
        case BeamEdge::mixed:
            return light.intensity * (cone / 2 * (1 + light.q));
    }
    return {};
}

Rgb illuminance(const Spotlight& light, const Vec3& point, const Vec3& normal) {
    const Vec3 towards = light.position - point;
    const double distance = towards.length();
    return inverse_square_illuminance(intensity_towards(light, point), distance,
                                      normal.dot(towards) / distance);
}

} // namespace keiko
