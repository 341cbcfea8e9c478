#include "keiko/render/reflection/lamp_kernels.h"

#include "keiko/light/tubes/c_plane_lookup.h"
#include "keiko/light/tubes/ray_cone.h"
#include "keiko/render/reflection/image_bend.h"
#include "keiko/simd/batch.h"

#include <array>

namespace keiko::KEIKO_LEVEL {
namespace {

/// Coverage of a few lanes by end_coverage() and the like; 0 in the others.
Batch coverage_one_by_one(const StripeRow& row, const CPlaneHitT<Batch>& hit,
                          const FootprintT<Batch>& image, Mask wanted) {
    constexpr std::size_t count = 12;
    const std::array<Batch, count> all{
        hit.t,      hit.u,      hit.v,      hit.direction.x, hit.direction.y, hit.direction.z,
        image.dx.x, image.dx.y, image.dy.x, image.dy.y,      image.descent.x, image.descent.y};
    double of[count][lanes], found[lanes];
    for (std::size_t i = 0; i < count; ++i) all[i].store(of[i]);
    const std::uint32_t bits = bits_of(wanted);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        found[lane] = 0;
        if ((bits >> lane & 1) == 0) continue;
        double numbers[count];
        for (std::size_t i = 0; i < count; ++i) numbers[i] = of[i][lane];
        found[lane] = coverage_of_numbers(row, numbers);
    }
    return Batch::load(found);
}

/// LampCoverage::coverage, of images that are no points.
Batch coverage(const StripeRow& row, const CPlaneHitT<Batch>& hit, const FootprintT<Batch>& image) {
    const CPlaneFrame& frame = row.frame;
    if (frame.lamps == 0) return 0;
    const Mask met = is_met(hit);
    const Mask among =
        row.look == MirrorModel::tube ? met && starts_among_tubes(frame, hit) : Mask(false);
    const StripeCoverage<Batch> stripes(frame, row.look, met && !among, hit, image);
    const Mask others = stripes.at_ends || among;
    if (!any_of(others)) return stripes.coverage;
    return select(others, coverage_one_by_one(row, hit, image, others), stripes.coverage);
}

void look_at_batch(const StripeRow& row, const ReflectedRays& rays, std::size_t place,
                   std::size_t width, bool thorough, std::size_t lane, LampCoverageBatch& looks) {
    const PixelRaysT<Batch> pixel = rays.around<Batch>(place + lane, width, Batch::load);
    const CPlaneHitT<Batch> hit =
        c_plane_hit(row.frame, pixel.centre.origin, pixel.centre.direction);
    const Mask met = is_met(hit), missed = misses_lamps(row.frame, cone_of(pixel));
    looks.missed |= bits_of(missed) << lane;
    looks.meets |= bits_of(met) << lane;
    if (!any_of(met)) return;
    hit.t.store(looks.t.data() + lane);
    hit.u.store(looks.u.data() + lane), hit.v.store(looks.v.data() + lane);
    if (thorough)
        ReflectedFootprintT<Batch>(pixel)
            .residual(pixel, hit.t)
            .store(looks.residual.data() + lane);
    const bool dark = !any_of(met && !missed);
    if (dark && !thorough) return;
    const FootprintT<Batch> image = footprint_on(row.frame, hit, pixel.centre.spread);
    const ImageBend<Batch> bend(row.frame, pixel, hit, image);
    bend.bend.store(looks.bend.data() + lane);
    looks.bounded |= bits_of(bend.bounded) << lane;
    looks.points |= bits_of(image.is_point()) << lane;
    if (!dark) coverage(row, hit, image).store(looks.coverage.data() + lane);
}

[[gnu::flatten]] void look(const StripeRow& row, const ReflectedRays& rays, std::size_t place,
                           std::size_t width, bool thorough, LampCoverageBatch& looks) {
    looks.meets = looks.missed = looks.bounded = looks.points = 0;
    for (std::size_t lane = 0; lane < LampCoverageBatch::capacity; lane += lanes)
        look_at_batch(row, rays, place, width, thorough, lane, looks);
}

/// Parts are summed up by their place modulo 8, in the same order on every instruction set.
[[gnu::flatten]] double coverage_of_parts(const StripeRow& row, const ReflectedRays& rays,
                                          std::size_t place, std::size_t width,
                                          const SquareParts& parts) {
    const auto every = [](const double* number) { return Batch(*number); };
    const ReflectedFootprintT<Batch> cubic(rays.around<Batch>(place, width, every));
    constexpr std::size_t capacity = LampCoverageBatch::capacity;
    const double side = parts.side, count = side * side;
    double sums[capacity] = {};
    const auto at = [&](Batch number) { return (number + 0.5) * (1 / side) - 0.5; };
    std::size_t lane = 0;
    for (double first = 0; first < count; first += static_cast<double>(lanes)) {
        const Batch number = first + Batch::count();
        const Batch line = floor((number + 0.5) * (1 / side)), column = number - line * side;
        const PixelRayT<Batch> part = cubic.part(at(column), at(line), 1 / side);
        const CPlaneHitT<Batch> hit = c_plane_hit(row.frame, part.origin, part.direction);
        const Batch found = coverage(row, hit, footprint_on(row.frame, hit, part.spread));
        const Mask seen = number < Batch(count) && hit.t <= Batch(parts.t_max);
        (Batch::load(sums + lane) + select(seen, found, 0)).store(sums + lane);
        lane = (lane + lanes) % capacity;
    }
    double sum = 0;
    for (const double s : sums) sum += s;
    return sum / count;
}

} // namespace

LampKernels lamp_kernels() {
    return {look, coverage_of_parts};
}

} // namespace keiko::KEIKO_LEVEL
