#include "tests/support/long_run.h"
#include "tests/support/random_surfaces.h"
#include "tests/support/ray_tally.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

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
    /// Rays that a run of 1e8 rays once lost: by the face's seed and their number there.
    std::vector<std::pair<std::uint64_t, std::size_t>> once_lost{};
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
/// double. So the only errors allowed are each hit's own position bound and the reference's error
/// (1e-19 of the size, over the sine of the angle).
TEST_P(ConstructedRays, FindTheirPointAmongAllHits) {
    const Case& tested = GetParam();
    const auto count = static_cast<std::size_t>(
        tested.share * static_cast<double>(ray_count(1'000'000, 100'000'000)));
    RayTally tally(tested.name);
    for (std::uint64_t seed = first_seed(); tally.rays() < count; ++seed) {
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

class RaysOnceLost : public ConstructedRays {};

TEST_P(RaysOnceLost, FindTheirPoint) {
    const Case& tested = GetParam();
    RayTally tally(tested.name);
    for (const auto& [seed, number] : tested.once_lost) {
        Random random(seed);
        const RayScene scene(next_face(random), {.clipping_only = tested.clipping_only});
        std::optional<AimedRay> aimed;
        for (std::size_t i = 0; i <= number; ++i)
            aimed = scene.aim(random, ray_classes[i % ray_classes.size()]);
        ASSERT_TRUE(aimed);
        const std::string label =
            "face of seed " + std::to_string(seed) + ", ray " + std::to_string(number);
        tally.add(scene, *aimed, scene.judge(*aimed), label);
    }
    tally.expect_none_lost();
}

std::vector<Case> cases() {
    return {Case{"Polynomial", 1, 9, {}, 0.2, false, {{9693, 565}}},
            Case{"ByClippingOnly",
                 1,
                 5,
                 {.spans_u = 2, .weights = 3},
                 0.02,
                 true,
                 {{39, 401}, {1538, 821}, {1952, 702}}},
            Case{"Spans", 1, 5, {.spans_u = 3, .spans_v = 2}, 0.125, false, {{1810, 726}}},
            Case{"Folded", 2, 6, {.rough = 50}, 0.065, false, {{1803, 44}}},
            Case{"Flat", 1, 4, {.spans_u = 2, .rough = 0}, 0.03},
            Case{"Rational", 1, 9, {.weights = 10}, 0.15, false, {{464, 810}}},
            Case{"RationalSpans",
                 1,
                 4,
                 {.spans_u = 2, .spans_v = 3, .weights = 100},
                 0.07,
                 false,
                 {{1014, 317}, {4118, 537}}},
            Case{"WeightsAThousandthToAThousand",
                 1,
                 5,
                 {.rough = 8, .weights = 1e6},
                 0.05,
                 false,
                 {{259, 796},
                  {1052, 1013},
                  {2711, 124},
                  {2827, 229},
                  {2827, 509},
                  {3064, 817},
                  {3357, 152}}},
            Case{"Trimmed", 1, 6, {.spans_u = 2, .spans_v = 2, .trimmed = true}, 0.12},
            Case{"TrimmedRational", 1, 6, {.weights = 5, .trimmed = true}, 0.06},
            Case{"Placed", 1, 6, {.spans_u = 2, .weights = 3, .placed = true}, 0.02},
            Case{"Sheared", 1, 6, {.weights = 3, .placed = true, .shear = 3}, 0.01},
            Case{"FarOff", 1, 5, {.offset = Vec3(1e6, -1e6, 1e6)}, 0.04},
            Case{"Sliver", 1, 5, {.rough = 0.002, .length_u = 0.01}, 0.03, false, {{1085, 212}}},
            Case{"DegreeFifteen", 15, 15, {}, 0.015},
            Case{"DegreeTwentyFive", 25, 25, {}, 0.005}};
}

std::vector<Case> cases_once_lost() {
    std::vector<Case> some = cases();
    std::erase_if(some, [](const Case& tested) { return tested.once_lost.empty(); });
    return some;
}

std::string name_of(const testing::TestParamInfo<Case>& tested) {
    return tested.param.name;
}

INSTANTIATE_TEST_SUITE_P(Faces, ConstructedRays, testing::ValuesIn(cases()), name_of);
INSTANTIATE_TEST_SUITE_P(Faces, RaysOnceLost, testing::ValuesIn(cases_once_lost()), name_of);

} // namespace
} // namespace keiko
