#include "keiko/render/reflection/pixel_mirror.h"

#include "keiko/render/reflection/image_bend.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keiko {
namespace {

/// mm: span of a pixel's image across the lamps.
double span_across(const RigPlaneHit& plane, const RayDifferentials& spread) {
    const Footprint image = footprint_on(*plane.frame, plane.at, spread);
    return std::abs(image.dx.y) + std::abs(image.dy.y);
}

std::optional<double> bend_of(const RigPlaneHit& plane, const PixelRays& rays) {
    const Footprint image = footprint_on(*plane.frame, plane.at, rays.centre.spread);
    const ImageBend<double> bend(*plane.frame, rays, plane.at, image);
    if (!bend.bounded) return {};
    return bend.bend;
}

MirroredLight mean_over(const RigPlanes& planes, const ReflectedFootprint& pixel, int parts,
                        double t_max) {
    MirroredLight mean;
    for (int j = 0; j < parts; ++j)
        for (int i = 0; i < parts; ++i) {
            const PixelRay part =
                pixel.part((i + 0.5) / parts - 0.5, (j + 0.5) / parts - 0.5, 1.0 / parts);
            const MirroredLight seen =
                planes.luminance(part.origin, part.direction, part.spread, t_max);
            mean.luminance += seen.luminance;
            mean.coverage += seen.coverage;
            mean.resolved = mean.resolved && seen.resolved;
            mean.t = std::min(mean.t, seen.t);
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

PixelMirror mirror_of(const RigPlanes& planes, const Ray& centre,
                      const std::optional<PixelRays>& around, double t_max, bool tells_torn) {
    PixelMirror mirror{{}, planes.nearest(centre.origin, centre.direction)};
    if (!mirror.plane) return mirror;
    const bool dark = around && planes.are_missed_by(cone_of(*around));
    if (dark && !tells_torn) return mirror;
    const auto bend = around ? bend_of(*mirror.plane, *around) : std::nullopt;
    if (tells_torn && around)
        mirror.discontinuous =
            !bend || // the plane's horizon
            is_discontinuous(ReflectedFootprint(*around).residual(*around, mirror.plane->at.t),
                             *mirror.plane, around->centre.spread);
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
