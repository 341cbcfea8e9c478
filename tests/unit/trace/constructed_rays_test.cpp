#include "tests/support/long_run.h"
#include "tests/support/ray_tally.h"
#include "tests/unit/trace/random_surfaces.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>

namespace keiko {
namespace {

using namespace test;

/// How many rays a random face is kept for, and which share of them brute force sees.
constexpr std::size_t rays_a_face = 1000, rays_a_brute_force = 100;

struct Case {
    const char* name;
    /// Degrees are drawn anew for each face between these.
    int least_degree, most_degree;
    SurfaceKind kind;
    double share; ///< of the default run's and the long run's rays
    bool clipping_only = false;
};

/// Names the case where GoogleTest would print its bytes.
void PrintTo(const Case& tested, std::ostream* out) {
    *out << tested.name;
}

class ConstructedRays : public testing::TestWithParam<Case> {
protected:
    SurfaceModel next_face(Random& random) const {
        SurfaceKind kind = GetParam().kind;
        const auto degree = [&] {
            const auto range =
                static_cast<std::size_t>(GetParam().most_degree - GetParam().least_degree + 1);
            return GetParam().least_degree + static_cast<int>(pick(random, range));
        };
        kind.degree_u = degree();
        kind.degree_v = degree();
        return random_face(random, kind);
    }
};

/// Rays through known points of random faces: the point must be among all hits. The rays' doubles
/// are taken as exact and the point is moved to where such a ray really meets the surface, in long
/// double; so nothing is allowed for but each hit's own position bound and the reference's error
/// (1e-19 of the size, over the sine of the angle).
TEST_P(ConstructedRays, FindTheirPointAmongAllHits) {
    const Case& tested = GetParam();
    const auto count = static_cast<std::size_t>(
        tested.share * static_cast<double>(ray_count(1'000'000, 100'000'000)));
    RayTally tally(tested.name);
    for (std::uint64_t seed = 1; tally.rays() < count; ++seed) {
        Random random(seed);
        const RayScene scene(next_face(random), {.clipping_only = tested.clipping_only});
        const std::size_t end = std::min(count, tally.rays() + rays_a_face);
        for (std::size_t i = 0; tally.rays() < end; ++i) {
            const RayClass kind = ray_classes[i % ray_classes.size()];
            const auto aimed = scene.aim(random, kind);
            const std::string label =
                "face of seed " + std::to_string(seed) + ", ray " + std::to_string(i);
            if (!aimed) {
                tally.add_unmade();
                if (i > 10 * rays_a_face) break;
                continue;
            }
            tally.add(scene, *aimed, scene.judge(*aimed), label);
            if (i % rays_a_brute_force == 0)
                tally.add_brute_force(aimed->ray, scene.judge_by_brute_force(aimed->ray), label);
        }
    }
    tally.expect_none_lost();
}

INSTANTIATE_TEST_SUITE_P(
    Faces, ConstructedRays,
    testing::Values(Case{"Polynomial", 1, 9, {}, 0.2},
                    Case{"ByClippingOnly", 1, 5, {.spans_u = 2, .weights = 3}, 0.02, true},
                    Case{"Spans", 1, 5, {.spans_u = 3, .spans_v = 2}, 0.145},
                    Case{"Folded", 2, 6, {.rough = 50}, 0.065},
                    Case{"Flat", 1, 4, {.spans_u = 2, .rough = 0}, 0.03},
                    Case{"Rational", 1, 9, {.weights = 10}, 0.15},
                    Case{"RationalSpans", 1, 4, {.spans_u = 2, .spans_v = 3, .weights = 100}, 0.07},
                    Case{"WeightsAThousandthToAThousand", 1, 5, {.rough = 8, .weights = 1e6}, 0.05},
                    Case{"Trimmed", 1, 6, {.spans_u = 2, .spans_v = 2, .trimmed = true}, 0.12},
                    Case{"TrimmedRational", 1, 6, {.weights = 5, .trimmed = true}, 0.06},
                    Case{"FarOff", 1, 5, {.offset = Vec3(1e6, -1e6, 1e6)}, 0.04},
                    Case{"Sliver", 1, 5, {.rough = 0.002, .length_u = 0.01}, 0.03},
                    Case{"DegreeFifteen", 15, 15, {}, 0.015},
                    Case{"DegreeTwentyFive", 25, 25, {}, 0.005}),
    [](const auto& tested) { return std::string(tested.param.name); });

} // namespace
} // namespace keiko
