#include "keiko/render/reflection/reflected_footprint.h"

#include "keiko/light/tubes/end_coverage.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keiko {
namespace {

/// Part of a ray, or of a derivative of one, that determines its intersection with a plane along
/// one of its axes: the components along that axis and the plane's normal of origin and direction.
struct Slice {
    double origin, origin_height, direction, direction_height;

    Slice operator+(const Slice& o) const {
        return {origin + o.origin, origin_height + o.origin_height, direction + o.direction,
                direction_height + o.direction_height};
    }
    Slice operator-(const Slice& o) const {
        return {origin - o.origin, origin_height - o.origin_height, direction - o.direction,
                direction_height - o.direction_height};
    }
    Slice operator*(double s) const {
        return {origin * s, origin_height * s, direction * s, direction_height * s};
    }
};

/// Pixels' rays along an axis of a plane, 0 along the lamps, 1 across.
class Slicing {
public:
    Slicing(const CPlaneFrame& frame, unsigned axis)
        : frame_(frame), axis_(axis == 0 ? frame.u : frame.v) {}

    CubicFootprint<Slice> cubic(const PixelRays& rays) const {
        return {of(rays.centre.origin - frame_.origin, rays.centre.direction),
                slopes(rays.centre),
                slopes(rays.left),
                slopes(rays.right),
                slopes(rays.above),
                slopes(rays.below)};
    }

private:
    Slice of(const Vec3& origin, const Vec3& direction) const {
        return {axis_.dot(origin), frame_.normal.dot(origin), axis_.dot(direction),
                frame_.normal.dot(direction)};
    }
    Slopes<Slice> slopes(const Ray& ray) const {
        const RayDifferentials& d = *ray.differentials;
        return {of(d.origin_dx, d.direction_dx), of(d.origin_dy, d.direction_dy)};
    }

    const CPlaneFrame& frame_;
    const Vec3& axis_;
};

/// Places where the rays of a pixel's corners meet a plane along an axis, mm, row by row; nullopt
/// if one does not.
std::optional<std::array<double, 4>> corners_of(const CPlaneFrame& frame, unsigned axis,
                                                const PixelRays& rays) {
    std::array<double, 4> places{};
    const std::array<Slice, 4> corners = Slicing(frame, axis).cubic(rays).corners();
    for (std::size_t i = 0; i < 4; ++i) {
        const double t = -corners[i].origin_height / corners[i].direction_height;
        if (!(t > 0 && std::isfinite(t))) return {};
        places[i] = corners[i].origin + t * corners[i].direction;
    }
    return places;
}

/// Values of a linear function at the corners of a pixel at whose centre it is 0.
std::array<double, 4> linear_corners(double by_x, double by_y) {
    const double sum = (by_x + by_y) / 2, rise = (by_x - by_y) / 2;
    return {-sum, rise, -rise, sum};
}

/// Deviation of the image's corners along the lamps from the image assumed by end_coverage(), as a
/// share of its span, at most 1.
double bend_along(const CPlaneHit& hit, const Footprint& image, const std::array<double, 4>& at) {
    const auto told = linear_corners(image.dx.x, image.dy.x);
    const auto nearer = linear_corners(image.descent.x, image.descent.y);
    double off = 0;
    for (std::size_t i = 0; i < 4; ++i)
        off = std::max(off, std::abs(at[i] - hit.u - told[i] / (1 + nearer[i])));
    const double span = std::abs(image.dx.x) + std::abs(image.dy.x);
    return std::isfinite(image.reach(0)) ? std::min(off / span, 1.0) : 1.0;
}

bool may_hold_end(const RigPlaneHit& plane, const Footprint& image) {
    const double reach = image.reach(0) + image.widened(end_room(*plane.frame, plane.at.direction));
    const double begin = plane.at.u, end = plane.frame->length - begin;
    return std::abs(begin) < reach || std::abs(end) < reach;
}

} // namespace

std::optional<double> footprint_nonlinearity(const RigPlaneHit& plane, const PixelRays& rays) {
    const CPlaneFrame& frame = *plane.frame;
    const auto across = corners_of(frame, 1, rays);
    if (!across) return {};
    const Footprint image = footprint_on(frame, plane.at, *rays.centre.differentials);
    const auto told = linear_corners(image.dx.y, image.dy.y);
    double off = 0;
    for (std::size_t i = 0; i < 4; ++i)
        off = std::max(off, std::abs((*across)[i] - plane.at.v - told[i]));
    const double bend = off / frame.pitch;
    if (!may_hold_end(plane, image)) return bend;
    return std::max(bend, bend_along(plane.at, image, *corners_of(frame, 0, rays)));
}

namespace {

/// mm: span of a pixel's image across the lamps.
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

/// Bounds of the rays of a pixel. With m the largest deviation of neighbours' slopes from the
/// centre's, the second derivatives of the cubic are at most m, the third at most 2 m. The pixel
/// extends half a unit to all sides: that adds up to 1/8 + 1/8 + 1/4 + 4/48 + 4/16 times m. For the
/// slopes it adds up to 1/2 + 1/2 + 2/8 + 2/4 + 2/8.
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
