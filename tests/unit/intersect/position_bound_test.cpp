#include "keiko/intersect/traversal/tracer.h"

#include "tests/support/long_run.h"
#include "tests/support/random_surfaces.h"
#include "tests/support/ray_tally.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace keiko {
namespace {

using namespace test;

struct Case {
    const char* name;
    SurfaceKind kind;
    bool clipping_only;
    std::size_t rays;
};

/// Names the case where GoogleTest would print its bytes.
void PrintTo(const Case& tested, std::ostream* out) {
    *out << tested.name;
}

class PositionBound : public testing::TestWithParam<Case> {};

/// Position bounds that the hits of some rays report, against long double.
struct Comparison {
    std::size_t compared = 0, too_small = 0;
    std::size_t undecidable = 0; ///< nearer to tangency, or to the rim, than long double can tell
    double worst = 0;            ///< error over bound
    std::vector<double> bounds;
};

/// A tangential hit may stand for two roots, or for none where the ray just misses. The root that
/// Newton finds from there must be within the bound of some hit, and the hit near the ray.
double error_of(const Ray& ray, const Hit& hit, const std::vector<Hit>& hits,
                const ExactRoot& root) {
    const auto off = [&](const Hit& h) {
        const Long far = (lengthened(h.position) - root.position).length() - root.error;
        return static_cast<double>(far) / h.position_bound;
    };
    if (!has(hit.flags, HitFlags::tangential)) return off(hit);
    double least = off(hit);
    for (const Hit& other : hits) least = std::min(least, off(other));
    const auto beside = static_cast<double>(off_line(ray, lengthened(hit.position)));
    return std::max(least, beside / hit.position_bound);
}

void compare(const ExactPatch& patch, const Ray& ray, const std::vector<Hit>& hits,
             Comparison& sum) {
    for (const Hit& hit : hits) {
        const std::optional<ExactRoot> root = exact_root(patch, ray, hit.uv);
        if (!root || !root->on_patch()) {
            ++sum.undecidable;
            continue;
        }
        const double error = error_of(ray, hit, hits, *root);
        ++sum.compared;
        sum.bounds.push_back(hit.position_bound);
        sum.worst = std::max(sum.worst, error);
        if (error <= 1 || ++sum.too_small > 5) continue;
        std::cout << "off by " << error << " bounds of " << hit.position_bound << " mm, flags "
                  << static_cast<unsigned>(hit.flags) << ", uv " << hit.uv << ", sine "
                  << static_cast<double>(root->sine) << ", " << exact_text(ray) << "\n";
    }
}

/// Rays of the classes that keep inside a patch, for a border may give the hit to a neighbour.
Ray random_ray(Random& random, const ExactPatch& patch, RayClass kind) {
    for (;;) {
        const double u = uniform(random, 0, 1), v = uniform(random, 0, 1);
        const ExactPatch::Point p = patch.at(u, v);
        const Mark mark{shortened(p.position), shortened(p.normal()), shortened(p.du.normalized()),
                        shortened(p.dv.normalized())};
        if (is_finite(mark.normal) && mark.normal.length() > 0.5)
            return ray_at(mark, kind, std::pow(10, uniform(random, 1, 4)), random);
    }
}

TEST_P(PositionBound, HoldsAgainstLongDoubleAndIsNarrow) {
    const Case& tested = GetParam();
    const std::size_t count = ray_count(tested.rays, 100 * tested.rays);
    Comparison sum;
    for (std::size_t i = 0; i < count;) {
        Random random(first_seed() + i);
        const SurfaceModel model = random_face(random, tested.kind);
        const Tracer tracer(model, {.clipping_only = tested.clipping_only});
        const ExactPatch patch(model.patch(0), model.instances[0].transform);
        for (const std::size_t end = std::min(count, i + 500); i < end; ++i) {
            const RayClass kind = i % 4 == 0 ? RayClass::grazing : RayClass::random;
            const Ray ray = random_ray(random, patch, kind);
            compare(patch, ray, tracer.all(ray), sum);
        }
    }
    ASSERT_GT(sum.compared, count / 2);
    std::nth_element(sum.bounds.begin(), sum.bounds.begin() + sum.bounds.size() / 2,
                     sum.bounds.end());
    const double median = sum.bounds[sum.bounds.size() / 2];
    std::cout << tested.name << ": " << sum.compared << " hits, bound too small " << sum.too_small
              << ", median bound " << median << " mm, largest error over bound " << sum.worst
              << ", undecidable " << sum.undecidable << "\n";
    EXPECT_EQ(sum.too_small, 0u);
    // Far from the origin the coordinates' own last place is the measure.
    constexpr double last_places = 512 * std::numeric_limits<double>::epsilon();
    EXPECT_LT(median, 1e-9 * 100 + last_places * tested.kind.offset.length());
}

INSTANTIATE_TEST_SUITE_P(
    Patches, PositionBound,
    testing::Values(Case{"Bicubic", {}, false, 160000}, Case{"BicubicClipped", {}, true, 16000},
                    Case{"Folded", {.rough = 60}, false, 80000},
                    Case{"Biquintic", {.degree_u = 5, .degree_v = 5}, false, 80000},
                    Case{"Rational", {.degree_u = 2, .weights = 10}, false, 80000},
                    Case{"WeightsAThousandthToAThousand", {.weights = 1e6}, false, 80000},
                    Case{"DegreeFifteen", {.degree_u = 15, .degree_v = 15}, false, 8000},
                    Case{"FarOff", {.offset = Vec3(1e6, 1e6, -1e6)}, false, 40000},
                    Case{"Sheared", {.weights = 3, .placed = true, .shear = 3}, false, 20000},
                    Case{"ShearedClipped", {.placed = true, .shear = 3}, true, 4000}),
    [](const auto& tested) { return std::string(tested.param.name); });

} // namespace
} // namespace keiko
