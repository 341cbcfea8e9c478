#include "keiko/render/reflection/lamp_reflections.h"

#include <algorithm>
#include <limits>

namespace keiko {
namespace {

bool has_lane(std::uint32_t lanes, std::size_t lane) {
    return (lanes >> lane & 1) != 0;
}

} // namespace

double coverage_of_numbers(const StripeRow& row, const double numbers[12]) {
    const double* n = numbers;
    const CPlaneHit hit{n[0], n[1], n[2], {n[3], n[4], n[5]}};
    const Footprint footprint{{n[6], n[7]}, {n[8], n[9]}, {n[10], n[11]}};
    // Only points and exact models need the origin and the direction in the world.
    return look_up(row.frame, hit, Vec3(0), Vec3(0), footprint, row.look).coverage;
}

LampKernels lamp_kernels(SimdLevel level) {
    return KEIKO_AT_LEVEL(level, lamp_kernels);
}

LampReflections::LampReflections(const RigPlanes& planes, const ReflectedGrid& grid,
                                 const LampKernels& kernels, bool tells_torn)
    : planes_(planes),
      grid_(grid),
      kernels_(kernels),
      tells_torn_(tells_torn),
      is_plain_(
          std::any_of(planes.planes().begin(), planes.planes().end(),
                      [](const RigPlanes::Plane& p) { return p.mirror == MirrorModel::exact; })),
      first_(std::numeric_limits<std::size_t>::max()),
      looks_(planes.planes().size()) {}

void LampReflections::find(std::size_t place, double t_max, PixelMirror& mirror) {
    if (is_plain_ || !grid_.is_amid(place)) {
        mirror = plainly({place, 0, t_max});
        return;
    }
    if (place < first_ || place - first_ >= LampCoverageBatch::capacity) look(place);
    const Pixel pixel{place, place - first_, t_max};
    const std::size_t number = nearest(pixel.lane);
    if (number == looks_.size()) return;
    set_hit(number, pixel, mirror.plane.emplace());
    const bool dark = is_dark(pixel.lane);
    if (dark && !tells_torn_) return;
    const LampCoverageBatch& seen = looks_[number];
    const bool bounded = has_lane(seen.bounded, pixel.lane);
    mirror.discontinuous =
        tells_torn_ && (!bounded || // the plane's horizon
                        is_discontinuous(seen.residual[pixel.lane], *mirror.plane,
                                         grid_.rays().ray(place).spread));
    if (dark) return;
    const bool bent = bounded && !(seen.bend[pixel.lane] <= straight_image);
    const int parts = bent ? parts_of_bend(seen.bend[pixel.lane]) : 1;
    if (!find_lamps(pixel, parts, mirror.lamps)) mirror = plainly(pixel);
}

PixelMirror LampReflections::plainly(const Pixel& pixel) const {
    return mirror_of(planes_, grid_.ray(pixel.place), grid_.around(pixel.place), pixel.t_max,
                     tells_torn_);
}

void LampReflections::look(std::size_t place) {
    first_ = place;
    const auto planes = planes_.planes();
    const bool thorough = tells_torn_ || planes.size() > 1;
    for (std::size_t i = 0; i < planes.size(); ++i)
        kernels_.look({planes[i].frame, planes[i].mirror}, grid_.rays(), place, grid_.width(),
                      thorough, looks_[i]);
}

bool LampReflections::is_dark(std::size_t lane) const {
    return std::all_of(looks_.begin(), looks_.end(), [&](const LampCoverageBatch& looks) {
        return has_lane(looks.missed, lane);
    });
}

std::size_t LampReflections::nearest(std::size_t lane) const {
    std::size_t nearest = looks_.size();
    const auto distance = [&](std::size_t i) {
        const std::size_t level = planes_.planes()[i].level;
        return looks_[has_lane(looks_[level].meets, lane) ? level : i].t[lane];
    };
    for (std::size_t i = 0; i < looks_.size(); ++i)
        if (has_lane(looks_[i].meets, lane) &&
            (nearest == looks_.size() || distance(i) < distance(nearest)))
            nearest = i;
    return nearest;
}

void LampReflections::set_hit(std::size_t number, const Pixel& pixel, RigPlaneHit& hit) const {
    const RigPlanes::Plane& plane = planes_.planes()[number];
    const LampCoverageBatch& looks = looks_[number];
    hit.source = plane.source, hit.number = number;
    hit.frame = &plane.frame;
    hit.at.t = looks.t[pixel.lane];
    hit.at.u = looks.u[pixel.lane], hit.at.v = looks.v[pixel.lane];
    hit.at.direction =
        plane.frame.vector(grid_.rays().vector(ReflectedRays::direction, pixel.place));
}

bool LampReflections::find_lamps(const Pixel& pixel, int parts, MirroredLight& light) const {
    const auto planes = planes_.planes();
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const LampCoverageBatch& looks = looks_[i];
        if (has_lane(looks.missed, pixel.lane)) continue;
        if (has_lane(looks.points, pixel.lane)) return false;
        double coverage = 0;
        if (parts > 1)
            coverage = kernels_.coverage_of_parts({planes[i].frame, planes[i].mirror}, grid_.rays(),
                                                  pixel.place, grid_.width(), {parts, pixel.t_max});
        else if (has_lane(looks.meets, pixel.lane) && looks.t[pixel.lane] <= pixel.t_max)
            coverage = looks.coverage[pixel.lane];
        if (coverage == 0) continue;
        if (light.coverage > 0) return false;
        light.luminance = planes[i].luminance * coverage;
        light.coverage = coverage;
        light.t = looks.t[pixel.lane];
    }
    return true;
}

} // namespace keiko
