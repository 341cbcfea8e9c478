// The kernels against the formulas for a pixel alone, on every instruction set: the same templates,
// so the same bits.
#include "keiko/render/reflection/lamp_kernels.h"

#include "keiko/light/tubes/c_plane_lookup.h"
#include "keiko/light/tubes/ray_cone.h"
#include "keiko/render/reflection/image_bend.h"
#include "keiko/render/reflection/pixel_mirror.h"

#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

using namespace keiko;
using namespace keiko::test;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t width = LampCoverageBatch::capacity + 2, first = width + 1;

Vec3 any_vector(Random& random, double size) {
    return Vec3(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)) * size;
}

/// A vector that changes with the place in the picture, bent by `bend` of its slope.
struct Bent {
    Vec3 base, by_x, by_y, xx, xy, yy;

    Bent(Random& random, const Vec3& at, double slope, double bend)
        : base(at),
          by_x(any_vector(random, slope)),
          by_y(any_vector(random, slope)),
          xx(any_vector(random, slope * bend)),
          xy(any_vector(random, slope * bend)),
          yy(any_vector(random, slope * bend)) {}

    Vec3 at(double x, double y) const {
        return base + by_x * x + by_y * y + xx * (x * x) + xy * (x * y) + yy * (y * y);
    }
    Vec3 dx(double x, double y) const { return by_x + xx * (2 * x) + xy * y; }
    Vec3 dy(double x, double y) const { return by_y + xy * x + yy * (2 * y); }
};

/// Three rows of pixels whose reflected rays go towards a row of lamps, or past it.
struct Strip {
    std::array<Ray, 3 * width> rays;
    ReflectedRays numbers{3 * width};

    explicit Strip(Random& random) {
        const double bend = std::pow(10, uniform(random, -4, -1));
        const double slope = std::pow(10, uniform(random, -1, 2));
        const Bent origin(random, any_vector(random, 300), slope, bend);
        const Bent direction(random, Vec3(0, 0, 0.5) + any_vector(random, 0.5), slope / 500, bend);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const double x = static_cast<double>(i % width) - 4.5;
            const double y = static_cast<double>(i / width) - 1.0;
            rays[i].origin = origin.at(x, y), rays[i].direction = direction.at(x, y);
            rays[i].differentials = {origin.dx(x, y), origin.dy(x, y), direction.dx(x, y),
                                     direction.dy(x, y)};
            numbers.set(i, rays[i]);
        }
    }
    PixelRays around(std::size_t place) const {
        return numbers.around<double>(place, width, [](const double* number) { return *number; });
    }
};

CPlane any_row(Random& random) {
    CPlane row;
    const double height = uniform(random, 0, 1) < 0.2 ? 0 : 1500; // or rays start among the tubes
    row.origin = Vec3(-1500, -1500, height) + any_vector(random, 500);
    row.u = Vec3(3000, 0, 0) + any_vector(random, 400);
    row.v = Vec3(0, 2500, 0) + any_vector(random, 400);
    row.lamps = 1 + static_cast<int>(uniform(random, 0, 20));
    row.diameter = uniform(random, 0.1, 1) * row.v.length() / row.lamps;
    row.luminous_caps = uniform(random, 0, 1) < 0.5;
    return row;
}

/// How much of the lamps a ray with a footprint sees.
double coverage_of(const StripeRow& row, const Vec3& origin, const Vec3& direction,
                   const RayDifferentials& spread, double t_max = infinity) {
    const auto hit = c_plane_coordinates(row.frame, origin, direction);
    if (!hit || hit->t > t_max) return 0;
    return look_up(row.frame, *hit, origin, direction, footprint_on(row.frame, *hit, spread),
                   row.look)
        .coverage;
}

double coverage_of_parts(const StripeRow& row, const PixelRays& rays, const SquareParts& parts) {
    const ReflectedFootprint pixel(rays);
    double sum = 0;
    for (int j = 0; j < parts.side; ++j)
        for (int i = 0; i < parts.side; ++i) {
            const PixelRay part = pixel.part((i + 0.5) / parts.side - 0.5,
                                             (j + 0.5) / parts.side - 0.5, 1.0 / parts.side);
            sum += coverage_of(row, part.origin, part.direction, part.spread, parts.t_max);
        }
    return sum / (parts.side * parts.side);
}

/// Which cases were met.
struct Met {
    int pixels = 0, missed = 0, lit = 0, partly = 0, unbounded = 0, bent = 0, at_ends = 0,
        among = 0;
};

bool has(std::uint32_t set, std::size_t lane) {
    return (set >> lane & 1) != 0;
}

void compare(const StripeRow& row, const PixelRays& rays, const LampCoverageBatch& looks,
             std::size_t lane, Met& met) {
    const PixelRay& ray = rays.centre;
    const auto hit = c_plane_coordinates(row.frame, ray.origin, ray.direction);
    ASSERT_EQ(has(looks.missed, lane), misses_lamps(row.frame, cone_of(rays)));
    ASSERT_EQ(has(looks.meets, lane), hit.has_value());
    met.missed += has(looks.missed, lane);
    if (!hit) return;
    ++met.pixels;
    ASSERT_EQ(looks.t[lane], hit->t);
    ASSERT_EQ(looks.u[lane], hit->u);
    ASSERT_EQ(looks.v[lane], hit->v);
    const Footprint image = footprint_on(row.frame, *hit, ray.spread);
    const ImageBend<double> bend(row.frame, rays, *hit, image);
    ASSERT_EQ(has(looks.bounded, lane), bend.bounded);
    met.unbounded += !bend.bounded;
    if (bend.bounded) {
        ASSERT_EQ(looks.bend[lane], bend.bend);
    }
    met.bent += bend.bounded && bend.bend > straight_image;
    const double reach = image.reach_along();
    met.at_ends += std::abs(hit->u) < reach || std::abs(row.frame.length - hit->u) < reach;
    ASSERT_EQ(looks.residual[lane], ReflectedFootprint(rays).residual(rays, hit->t));
    if (has(looks.missed, lane)) return;
    const double coverage = coverage_of(row, ray.origin, ray.direction, ray.spread);
    ASSERT_EQ(looks.coverage[lane], coverage);
    met.among += starts_among_tubes(row.frame, *hit);
    met.lit += coverage > 0, met.partly += coverage > 0 && coverage < 1;
}

} // namespace

TEST(LampKernels, ComputeWhatTheFormulasForOnePixelDo) {
    for (const SimdLevel level : simd_levels()) {
        const LampKernels kernels = lamp_kernels(level);
        SCOPED_TRACE(name_of(level));
        Random random(606);
        Met met;
        for (int trial = 0; trial < 8000; ++trial) {
            const CPlaneFrame frame(any_row(random));
            const StripeRow row{frame, trial % 2 == 0 ? MirrorModel::tube : MirrorModel::flat};
            const Strip strip(random);
            LampCoverageBatch looks;
            kernels.look(row, strip.numbers, first, width, true, looks);
            for (std::size_t lane = 0; lane < LampCoverageBatch::capacity; ++lane)
                ASSERT_NO_FATAL_FAILURE(compare(row, strip.around(first + lane), looks, lane, met))
                    << trial << ", " << lane;
        }
        EXPECT_GT(met.pixels, 20000);
        for (const int count :
             {met.missed, met.lit, met.partly, met.unbounded, met.bent, met.at_ends, met.among})
            EXPECT_GT(count, 500);
    }
}

TEST(LampKernels, SumUpPartsAsTheFormulasForOnePartDo) {
    for (const SimdLevel level : simd_levels()) {
        const LampKernels kernels = lamp_kernels(level);
        SCOPED_TRACE(name_of(level));
        Random random(607);
        int partly = 0;
        for (int trial = 0; trial < 8000; ++trial) {
            const CPlaneFrame frame(any_row(random));
            const StripeRow row{frame, trial % 2 == 0 ? MirrorModel::tube : MirrorModel::flat};
            const Strip strip(random);
            const SquareParts parts{1 + trial % 8, trial % 3 == 0 ? 1700 : infinity};
            const double coverage =
                kernels.coverage_of_parts(row, strip.numbers, first + 3, width, parts);
            EXPECT_NEAR(coverage, coverage_of_parts(row, strip.around(first + 3), parts), 1e-14)
                << trial;
            partly += coverage > 0 && coverage < 1;
        }
        EXPECT_GT(partly, 500);
    }
}
