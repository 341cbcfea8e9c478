#include "keiko/render/mirrored_pixel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keiko {
namespace {

/// Of the lamps' pitch: how far the image of a pixel, or of a part of one, may be off a
/// parallelogram.
constexpr double straight = 0.01;
constexpr double most_parts = 8; ///< a side of a pixel

/// Of the pitch: by how much neighbours' rays may be off what the pixel tells of them.
constexpr double whole = 0.1;

/// How the image of a pixel on the nearest C-plane differs from the parallelogram that its centre
/// tells, in pitches.
struct Image {
    double bend = 0;   ///< of its corners, across the lamps
    double misfit = 0; ///< of its neighbours
};

Image image_of(const RigPlanes& planes, const Ray& centre, const MirroredPixel& pixel) {
    const auto plane = planes.nearest(centre.origin, centre.direction);
    if (!plane) return {};
    const CPlaneFrame& frame = *plane->frame;
    const Footprint expected =
        footprint_on(frame, plane->at, centre.direction, *centre.differentials);
    double off = 0;
    for (const Vec2& corner :
         {Vec2(-0.5, -0.5), Vec2(0.5, -0.5), Vec2(-0.5, 0.5), Vec2(0.5, 0.5)}) {
        const Ray ray = pixel.ray(corner.x, corner.y);
        const auto at = c_plane_coordinates(frame, ray.origin, ray.direction);
        if (!at) return {};
        off = std::max(off, std::abs(at->v - plane->at.v - expected.dx.y * corner.x -
                                     expected.dy.y * corner.y));
    }
    return {off / frame.pitch, pixel.misfit(plane->at.t) / frame.pitch};
}

MirroredLight mean_over(const RigPlanes& planes, const MirroredPixel& pixel, int parts,
                        double t_max) {
    MirroredLight mean;
    for (int j = 0; j < parts; ++j)
        for (int i = 0; i < parts; ++i) {
            const Ray ray =
                pixel.ray((i + 0.5) / parts - 0.5, (j + 0.5) / parts - 0.5, 1.0 / parts);
            const MirroredLight part =
                planes.luminance(ray.origin, ray.direction, ray.differentials, t_max);
            mean.luminance += part.luminance;
            mean.coverage += part.coverage;
            mean.resolved = mean.resolved && part.resolved;
        }
    mean.luminance *= 1.0 / (parts * parts);
    mean.coverage /= parts * parts;
    return mean;
}

} // namespace

MirroredPixel::Jet MirroredPixel::by_x(const Ray& ray) {
    return {ray.differentials->origin_dx, ray.differentials->direction_dx};
}

MirroredPixel::Jet MirroredPixel::by_y(const Ray& ray) {
    return {ray.differentials->origin_dy, ray.differentials->direction_dy};
}

MirroredPixel::MirroredPixel(const Ray& centre, const Ray& left, const Ray& right, const Ray& above,
                             const Ray& below)
    : value_{centre.origin, centre.direction},
      x_(by_x(centre)),
      y_(by_y(centre)),
      xx_((by_x(right) - by_x(left)) * 0.5),
      xy_((by_x(below) - by_x(above) + by_y(right) - by_y(left)) * 0.25),
      yy_((by_y(below) - by_y(above)) * 0.5),
      xxx_(by_x(right) - x_ * 2 + by_x(left)),
      xxy_(by_y(right) - y_ * 2 + by_y(left)),
      xyy_(by_x(below) - x_ * 2 + by_x(above)),
      yyy_(by_y(below) - y_ * 2 + by_y(above)) {
    compare(left, -1, 0), compare(right, 1, 0);
    compare(above, 0, -1), compare(below, 0, 1);
}

void MirroredPixel::compare(const Ray& neighbour, double x, double y) {
    const Ray told = ray(x, y);
    misfit_.origin = std::max(misfit_.origin, (told.origin - neighbour.origin).length());
    misfit_.direction =
        std::max(misfit_.direction, (told.direction - neighbour.direction).length());
}

Ray MirroredPixel::ray(double x, double y) const {
    const Jet value = value_ + x_ * x + y_ * y + xx_ * (x * x / 2) + xy_ * (x * y) +
                      yy_ * (y * y / 2) + xxx_ * (x * x * x / 6) + xxy_ * (x * x * y / 2) +
                      xyy_ * (x * y * y / 2) + yyy_ * (y * y * y / 6);
    Ray ray;
    ray.origin = value.origin;
    ray.direction = value.direction;
    return ray;
}

Ray MirroredPixel::ray(double x, double y, double share) const {
    const Jet dx =
        (x_ + xx_ * x + xy_ * y + xxx_ * (x * x / 2) + xxy_ * (x * y) + xyy_ * (y * y / 2)) * share;
    const Jet dy =
        (y_ + xy_ * x + yy_ * y + xxy_ * (x * x / 2) + xyy_ * (x * y) + yyy_ * (y * y / 2)) * share;
    Ray ray = this->ray(x, y);
    ray.differentials = RayDifferentials{dx.origin, dy.origin, dx.direction, dy.direction};
    return ray;
}

MirroredGrid::MirroredGrid(int width, std::span<const LitSpot> spots)
    : spots_(width, static_cast<int>(spots.back().sample) / width + 1, spots),
      rays_(spots_.size()) {}

std::optional<MirroredPixel> MirroredGrid::pixel(std::size_t sample) const {
    const auto width = static_cast<std::size_t>(spots_.width());
    const int x = static_cast<int>(sample % width), y = static_cast<int>(sample / width);
    if (x == 0 || y == 0 || !spots_.goes_right(x, y) || !spots_.goes_down(x, y) ||
        !spots_.goes_right(x - 1, y) || !spots_.goes_down(x, y - 1))
        return {};
    const std::array around{rays_[sample], rays_[sample - 1], rays_[sample + 1],
                            rays_[sample - width], rays_[sample + width]};
    const auto told = [](const Ray* ray) { return ray && ray->differentials; };
    if (!std::all_of(around.begin(), around.end(), told)) return {};
    return MirroredPixel(*around[0], *around[1], *around[2], *around[3], *around[4]);
}

PixelMirror mirror_of(const RigPlanes& planes, const Ray& centre,
                      const std::optional<MirroredPixel>& pixel, double t_max) {
    const Image image = pixel ? image_of(planes, centre, *pixel) : Image();
    if (image.bend <= straight)
        return {planes.luminance(centre.origin, centre.direction, centre.differentials, t_max),
                image.misfit > whole};
    const double parts = std::ceil(std::sqrt(image.bend / straight));
    return {mean_over(planes, *pixel, static_cast<int>(std::min(parts, most_parts)), t_max),
            image.misfit > whole};
}

} // namespace keiko
