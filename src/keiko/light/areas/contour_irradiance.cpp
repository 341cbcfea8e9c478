#include "keiko/light/areas/area_irradiance.h"
#include "keiko/light/areas/contour_width.h"
#include "keiko/math/quadrature.h"

#include <algorithm>

namespace keiko {

SphereLight sphere_around(const ContourLight& light) {
    const Box3& box = light.body->bounds();
    return {box.center(), box.size() / 2, light.luminance};
}

std::vector<Vec3> bounds_of(const ContourLight& light) {
    // A box along the lines of any view is within the sphere of its own corners around this one's.
    return bounds_of(SphereLight{light.body->bounds().center(), light.body->bounds().size()});
}

double projected_solid_angle(const ContourWidth& width, double error) {
    constexpr int most_halvings = 12; // where the contour meets the horizon
    const auto sent = [&](double place) {
        const SubAxis axis = width.sub_axis(place);
        return width.lit(axis, 0, 1) * axis.weight;
    };
    const std::vector<double> cuts = width.cuts();
    double sum = 0;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
        sum += integrate_paired(sent, Breakpoints(cuts[i], cuts[i + 1]), error, most_halvings);
    return sum;
}

double projected_solid_angle(const ContourLight& light, const Vec3& point, const Vec3& normal,
                             double error) {
    double sum = 0;
    for (const ContourWidth& width : ContourWidth::all(light, point, normal, error))
        sum += projected_solid_angle(width, error);
    return sum;
}

bool holds(const ContourLight& light, const Vec3& point) {
    return light.body->contains(point);
}

} // namespace keiko
