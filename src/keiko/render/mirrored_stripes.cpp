#include "keiko/render/mirrored_stripes.h"

#include <algorithm>
#include <limits>

namespace keiko {
namespace {

bool has_lane(std::uint32_t lanes, std::size_t lane) {
    return (lanes >> lane & 1) != 0;
}

} // namespace

MirroredStripes::MirroredStripes(const RigPlanes& planes, const MirroredGrid& grid,
                                 const StripeKernels& kernels, bool tells_torn)
    : planes_(planes),
      grid_(grid),
      kernels_(kernels),
      tells_torn_(tells_torn),
      is_plain_(std::any_of(planes.planes().begin(), planes.planes().end(),
                            [](const RigPlanes::Plane& p) { return p.mirror == TubeLook::exact; })),
      first_(std::numeric_limits<std::size_t>::max()),
      looks_(planes.planes().size()) {}

PixelMirror MirroredStripes::at(std::size_t place, const Ray& centre, double t_max) {
    const bool alone = is_plain_ || !grid_.is_amid(place);
    if (alone) return plainly({place, 0, centre, t_max});
    if (place < first_ || place - first_ >= StripeLooks::capacity) look(place);
    const Pixel pixel{place, place - first_, centre, t_max};
    const auto number = nearest(pixel.lane);
    if (!number) return {};
    PixelMirror mirror{{}, hit_on(*number, pixel)};
    const bool dark = is_dark(pixel.lane);
    if (dark && !tells_torn_) return mirror;
    const StripeLooks& seen = looks_[*number];
    const bool bounded = has_lane(seen.bounded, pixel.lane);
    mirror.torn =
        tells_torn_ && (!bounded || // the plane's horizon
                        seen.misfit[pixel.lane] > whole_image * mirror.plane->frame->pitch);
    if (dark) return mirror;
    const bool bent = bounded && !(seen.bend[pixel.lane] <= straight_image);
    const auto light = lamps(pixel, bent ? parts_of_bend(seen.bend[pixel.lane]) : 1);
    if (!light) return plainly(pixel);
    mirror.lamps = *light;
    return mirror;
}

PixelMirror MirroredStripes::plainly(const Pixel& pixel) const {
    return mirror_of(planes_, pixel.centre, grid_.around(pixel.place), pixel.t_max, tells_torn_);
}

void MirroredStripes::look(std::size_t place) {
    first_ = place;
    const auto planes = planes_.planes();
    const bool thorough = tells_torn_ || planes.size() > 1;
    for (std::size_t i = 0; i < planes.size(); ++i)
        kernels_.look({planes[i].frame, planes[i].mirror}, grid_.rays(), place, grid_.width(),
                      thorough, looks_[i]);
}

bool MirroredStripes::is_dark(std::size_t lane) const {
    return std::all_of(looks_.begin(), looks_.end(),
                       [&](const StripeLooks& looks) { return has_lane(looks.missed, lane); });
}

std::optional<std::size_t> MirroredStripes::nearest(std::size_t lane) const {
    std::optional<std::size_t> nearest;
    for (std::size_t i = 0; i < looks_.size(); ++i)
        if (has_lane(looks_[i].meets, lane) &&
            (!nearest || looks_[i].t[lane] < looks_[*nearest].t[lane]))
            nearest = i;
    return nearest;
}

RigPlaneHit MirroredStripes::hit_on(std::size_t number, const Pixel& pixel) const {
    const RigPlanes::Plane& plane = planes_.planes()[number];
    const StripeLooks& looks = looks_[number];
    const std::size_t lane = pixel.lane;
    return {
        plane.source,
        {looks.t[lane], looks.u[lane], looks.v[lane], plane.frame.vector(pixel.centre.direction)},
        &plane.frame,
        number};
}

std::optional<MirroredLight> MirroredStripes::lamps(const Pixel& pixel, int parts) const {
    MirroredLight light;
    const auto planes = planes_.planes();
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const StripeLooks& looks = looks_[i];
        if (has_lane(looks.missed, pixel.lane)) continue;
        if (has_lane(looks.points, pixel.lane)) return std::nullopt;
        double coverage = 0;
        if (parts > 1)
            coverage = kernels_.coverage_of_parts({planes[i].frame, planes[i].mirror}, grid_.rays(),
                                                  pixel.place, grid_.width(), {parts, pixel.t_max});
        else if (has_lane(looks.meets, pixel.lane) && looks.t[pixel.lane] <= pixel.t_max)
            coverage = looks.coverage[pixel.lane];
        if (coverage == 0) continue;
        if (light.coverage > 0) return std::nullopt;
        light = {planes[i].luminance * coverage, coverage};
    }
    return light;
}

} // namespace keiko
