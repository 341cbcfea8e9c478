#include "keiko/render/reflection/reflected_footprint.h"

#include "keiko/render/reflection/footprint_nonlinearity.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// mm: what a pixel's image spans across the lamps.
double span_across(const RigPlaneHit& plane, const RayDifferentials& spread) {
    const Footprint image = footprint_on(*plane.frame, plane.at, spread);
    return std::abs(image.dx.y) + std::abs(image.dy.y);
}

MirroredLight mean_over(const RigPlanes& planes, const ReflectedFootprint& pixel, int parts,
                        double t_max) {
    MirroredLight mean;
    for (int j = 0; j < parts; ++j)
        for (int i = 0; i < parts; ++i) {
            const SubpixelRay part =
                pixel.part((i + 0.5) / parts - 0.5, (j + 0.5) / parts - 0.5, 1.0 / parts);
            const MirroredLight seen =
                planes.luminance(part.origin, part.direction, part.spread, t_max);
            mean.luminance += seen.luminance;
            mean.coverage += seen.coverage;
            mean.resolved = mean.resolved && seen.resolved;
        }
    mean.luminance *= 1.0 / (parts * parts);
    mean.coverage /= parts * parts;
    return mean;
}

} // namespace

bool is_discontinuous(double residual, const RigPlaneHit& plane, const RayDifferentials& spread) {
    constexpr double most = 0.1, least = 0.02; // of the pitch
    constexpr double most_of_span = 0.05;
    const double pitch = plane.frame->pitch;
    if (!(residual > least * pitch)) return false;
    return residual > most * pitch || residual > most_of_span * span_across(plane, spread);
}

int parts_of_bend(double bend) {
    constexpr int most_parts = 8;
    const double parts = std::ceil(std::sqrt(bend / straight_image));
    return parts < most_parts ? std::max(static_cast<int>(parts), 1) : most_parts;
}

Slopes<ReflectedFootprint::Jet> ReflectedFootprint::slopes_of(const Ray& ray) {
    const RayDifferentials& d = *ray.differentials;
    return {{d.origin_dx, d.direction_dx}, {d.origin_dy, d.direction_dy}};
}

ReflectedFootprint::ReflectedFootprint(const PixelRays& rays)
    : cubic_({rays.centre.origin, rays.centre.direction}, slopes_of(rays.centre),
             slopes_of(rays.left), slopes_of(rays.right), slopes_of(rays.above),
             slopes_of(rays.below)) {}

/// With m the most that slopes of neighbours are off the centre's, the second derivatives of the
/// cubic are at most m, the third at most 2 m. In the pixel, half a unit to all sides, that adds up
/// to 1/8 + 1/8 + 1/4 + 4/48 + 4/16 times m, and for the slopes to 1/2 + 1/2 + 2/8 + 2/4 + 2/8.
RayCone ReflectedFootprint::bundle(const PixelRays& rays) {
    constexpr double off = 5.0 / 6, slope_off = 2;
    const RayDifferentials& own = *rays.centre.differentials;
    Vec2 most(0); // of origins, of directions; squared
    for (const Ray* neighbour : {&rays.left, &rays.right, &rays.above, &rays.below}) {
        const RayDifferentials& d = *neighbour->differentials;
        most.x = std::max({most.x, (d.origin_dx - own.origin_dx).length2(),
                           (d.origin_dy - own.origin_dy).length2()});
        most.y = std::max({most.y, (d.direction_dx - own.direction_dx).length2(),
                           (d.direction_dy - own.direction_dy).length2()});
    }
    const double origin = std::sqrt(most.x), direction = std::sqrt(most.y);
    return {rays.centre.origin, rays.centre.direction, own, off * origin, off * direction,
            slope_off * origin, slope_off * direction};
}

double ReflectedFootprint::residual(const PixelRays& rays, double t) const {
    Vec2 most(0); // of origins, of directions
    const auto compare = [&](const Ray& neighbour, double x, double y) {
        const Jet told = cubic_.at(x, y);
        most.x = std::max(most.x, (told.origin - neighbour.origin).length());
        most.y = std::max(most.y, (told.direction - neighbour.direction).length());
    };
    compare(rays.left, -1, 0), compare(rays.right, 1, 0);
    compare(rays.above, 0, -1), compare(rays.below, 0, 1);
    return most.x + t * most.y;
}

SubpixelRay ReflectedFootprint::part(double x, double y, double share) const {
    const Jet value = cubic_.at(x, y);
    const auto [by_x, by_y] = cubic_.slopes(x, y);
    const Jet dx = by_x * share, dy = by_y * share;
    return {value.origin, value.direction, {dx.origin, dy.origin, dx.direction, dy.direction}};
}

PixelMirror mirror_of(const RigPlanes& planes, const Ray& centre,
                      const std::optional<PixelRays>& around, double t_max, bool tells_torn) {
    PixelMirror mirror{{}, planes.nearest(centre.origin, centre.direction)};
    if (!mirror.plane) return mirror;
    const bool dark = around && planes.are_missed_by(ReflectedFootprint::bundle(*around));
    if (dark && !tells_torn) return mirror;
    const auto bend = around ? footprint_nonlinearity(*mirror.plane, *around) : std::nullopt;
    if (tells_torn && around)
        mirror.discontinuous =
            !bend || // the plane's horizon
            is_discontinuous(ReflectedFootprint(*around).residual(*around, mirror.plane->at.t),
                             *mirror.plane, *around->centre.differentials);
    if (dark) return mirror;
    if (!bend || *bend <= straight_image) {
        mirror.lamps = planes.luminance(mirror.plane, centre.origin, centre.direction,
                                        centre.differentials, t_max);
        return mirror;
    }
    mirror.lamps = mean_over(planes, ReflectedFootprint(*around), parts_of_bend(*bend), t_max);
    return mirror;
}

} // namespace keiko
