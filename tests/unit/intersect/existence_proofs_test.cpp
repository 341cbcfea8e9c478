#include "keiko/intersect/kernels/sub_patch_kernels.h"
#include "keiko/intersect/roots/root_finder.h"
#include "keiko/intersect/subpatch/sub_patch_frame.h"
#include "keiko/intersect/subpatch/traced_model.h"
#include "keiko/intersect/traversal/bezier_clipping.h"

#include "tests/support/instruction_sets.h"
#include "tests/support/random_patches.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace keiko {
namespace {

using namespace test;

/// Components and derivatives of a polynomial by powers, in long double.
struct Sample {
    std::array<long double, 4> value{}, x{}, y{}, xx{}, xy{}, yy{};
};

Sample sample(const SubPatchPolynomial& polynomial, int degree_u, int degree_v, double x,
              double y) {
    const auto power = [](long double t, int n) { return n < 0 ? 0 : std::pow(t, n); };
    Sample s;
    for (int i = 0; i <= degree_u; ++i)
        for (int j = 0; j <= degree_v; ++j)
            for (std::size_t c = 0; c < 4; ++c) {
                const auto at = static_cast<std::size_t>(i * (degree_v + 1) + j);
                const long double k = polynomial.coefficients[at][c];
                const long double px = power(x, i), py = power(y, j);
                const long double dx = i * power(x, i - 1), dy = j * power(y, j - 1);
                s.value[c] += k * px * py;
                s.x[c] += k * dx * py;
                s.y[c] += k * px * dy;
                s.xx[c] += k * i * (i - 1) * power(x, i - 2) * py;
                s.xy[c] += k * dx * dy;
                s.yy[c] += k * px * j * (j - 1) * power(y, j - 2);
            }
    return s;
}

struct Shape {
    int degree_u, degree_v;
    double rough, weights;
};

class SubPatchFrames : public testing::TestWithParam<Shape> {};

/// The bounds hold everywhere, and are not far above what they bound.
TEST_P(SubPatchFrames, BoundWhatTheySay) {
    const auto [degree_u, degree_v, rough, weights] = GetParam();
    Random random(211);
    double value_ratio = 0;
    for (int n = 0; n < 200 / (degree_u * degree_v + 10); ++n) {
        const PatchData patch = random_patch(random, degree_u, degree_v, rough, weights);
        const BezierPatchView view{degree_u, degree_v, patch.points};
        const SubPatchFrame frame = sub_patch_frame(view);
        ASSERT_TRUE(frame.regular);
        const SubPatchPolynomial polynomial = sub_patch_polynomial(view, frame);
        const std::array<const ComponentBounds*, 4> bounds{&frame.u, &frame.v, &frame.n, &frame.w};
        double largest = 0;
        for (int k = 0; k < 400; ++k) {
            const double x = uniform(random, -1, 1), y = uniform(random, -1, 1);
            const Sample s = sample(polynomial, degree_u, degree_v, x, y);
            const std::array<double, 4> flat_value{x, y, 0, 1}, flat_x{1, 0, 0, 0},
                flat_y{0, 1, 0, 0};
            for (std::size_t c = 0; c < 4; ++c) {
                const double slope = static_cast<double>(std::abs(s.x[c] - flat_x[c]) +
                                                         std::abs(s.y[c] - flat_y[c]));
                const double bend = static_cast<double>(std::abs(s.xx[c]) + 2 * std::abs(s.xy[c]) +
                                                        std::abs(s.yy[c]));
                const double value = static_cast<double>(std::abs(s.value[c] - flat_value[c]));
                EXPECT_LE(value, bounds[c]->value + 1e-15);
                EXPECT_LE(slope, bounds[c]->slope + 1e-15);
                EXPECT_LE(bend, bounds[c]->bend + 1e-13);
                if (c == 2) largest = std::max(largest, value);
            }
            EXPECT_LE(std::abs(static_cast<double>(s.value[2] / s.value[3])), frame.height + 1e-15);
            // And the polynomial is the surface.
            const Vec3 p = evaluate(view, Vec2(x + 1, y + 1) * 0.5, 0).position() - frame.center;
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_NEAR(frame.rows[c].dot(p), static_cast<double>(s.value[c] / s.value[3]),
                            polynomial.rounding[c] + polynomial.rounding[3] + 4e-14);
        }
        value_ratio = std::max(value_ratio, frame.n.value / largest);
    }
    EXPECT_LT(value_ratio, 4);
}

INSTANTIATE_TEST_SUITE_P(Patches, SubPatchFrames,
                         testing::Values(Shape{1, 1, 10, 1}, Shape{2, 2, 10, 1}, Shape{3, 3, 10, 1},
                                         Shape{5, 3, 5, 1}, Shape{3, 3, 5, 3}, Shape{2, 4, 5, 2},
                                         Shape{9, 9, 5, 1}));

/// All roots of a ray on a sub-patch by pure clipping.
std::vector<Vec2> clipped(const TracedModel& model, std::uint32_t index, const TracedRay& ray) {
    const PlacedSubPatch& placed = model.placed[index];
    const SubPatch& sub_patch = model.sub_patches.sub_patches[placed.sub_patch];
    const PartRay part =
        model.to_part(model.placements[placed.instance], ray.start, ray.direction, ray.error);
    RootFinder finder(true);
    std::vector<Vec2> roots;
    if (!near_sub_patch(part, sub_patch)) return roots;
    const RayProjection view = project_ray(part, sub_patch, model.sub_patches.view(sub_patch));
    for (const SubPatchRoot& root : finder.find(view.net, view.slack)) roots.push_back(root.uv);
    return roots;
}

struct Claims {
    int certain = 0, single = 0, undecided = 0, missed = 0, failed = 0, narrowed = 0,
        in_one_box = 0;
};

/// Checks the roots found with one box a ray, where that reaches a result.
void check_one_box(const TracedModel& model, const SubPatchKernels& kernels,
                   std::uint32_t sub_patch, const RayPacket& block, const std::vector<Vec2>& roots,
                   Claims& claims) {
    const PackedSubPatch& hot = model.hot[sub_patch];
    SubPatchRoots found;
    kernels.narrow(block, 1, hot, &model.sub_patches.polynomials[hot.polynomial], found);
    if (found.failed != 0) return;
    ++claims.in_one_box;
    ASSERT_EQ(std::popcount(found.found), static_cast<int>(roots.size()));
    if (found.found == 0) return;
    const Vec2 off = Vec2(found.x[0] + 1, found.y[0] + 1) * 0.5 - roots.front();
    EXPECT_LE(std::max(std::abs(off.x), std::abs(off.y)), found.error[0] * 0.5 + 1e-12);
}

/// Checks that boxes find what clipping finds on a sub-patch that the existence test leaves
/// undecided.
void check_narrowed(const TracedModel& model, const SubPatchKernels& kernels,
                    std::uint32_t sub_patch, const RayPacket& block, const std::vector<Vec2>& roots,
                    Claims& claims) {
    if (!model.hot[sub_patch].regular) return;
    check_one_box(model, kernels, sub_patch, block, roots, claims);
    std::vector<Crossing> found;
    if (!interval_newton(model, kernels, sub_patch, block, 0, found)) return;
    ++claims.narrowed;
    EXPECT_EQ(found.size(), roots.size());
    for (const Crossing& c : found)
        EXPECT_TRUE(std::any_of(roots.begin(), roots.end(), [&](const Vec2& uv) {
            return std::abs(uv.x - c.uv.x) <= c.error.x + 1e-12 &&
                   std::abs(uv.y - c.uv.y) <= c.error.y + 1e-12;
        }));
}

/// Checks that what the existence test proves of one ray is true by clipping, and that Newton finds
/// the same place.
void check_claims(const TracedModel& model, const SubPatchKernels& kernels, const SceneBall& ball,
                  const Ray& ray, Claims& claims) {
    RayPacket block;
    block.count = 1;
    block.rays[0] = &ray;
    kernels.enter(ball, block);
    if (block.active == 0) return;
    for (std::uint32_t i = 0; i < model.hot.size(); ++i) {
        ExistenceResult existence;
        kernels.existence_test_single(block, 0, model.hot[i], existence);
        const std::vector<Vec2> roots = clipped(model, i, block.ray(0));
        if (existence.undecided != 0) {
            ++claims.undecided;
            check_narrowed(model, kernels, i, block, roots, claims);
            continue;
        }
        if (existence.certain == 0 && existence.single == 0) {
            ++claims.missed;
            EXPECT_TRUE(roots.empty());
            continue;
        }
        ++(existence.certain != 0 ? claims.certain : claims.single);
        EXPECT_LE(roots.size(), 1u);
        if (existence.certain != 0) {
            EXPECT_EQ(roots.size(), 1u);
        }
        SubPatchRoots found;
        const Component4* polynomial = &model.sub_patches.polynomials[model.hot[i].polynomial];
        kernels.solve_single(block, 0, model.hot[i], polynomial, found);
        if (found.failed != 0) {
            ++claims.failed;
            continue;
        }
        ASSERT_EQ(std::popcount(found.found), static_cast<int>(roots.size()));
        if (found.found == 0) continue;
        const Vec2 uv = Vec2(found.x[0] + 1, found.y[0] + 1) * 0.5;
        EXPECT_LE((uv - roots.front()).length(), found.error[0] + 1e-12);
        EXPECT_GE(found.s[0], existence.nearest[0]);
        EXPECT_LE(found.s[0], existence.farthest[0]);
    }
}

TEST(SubPatchKernels, ProveWhatClippingFinds) {
    for (const std::int64_t set : instruction_sets()) {
        const WithInstructionSet only(set);
        const SubPatchKernels kernels = sub_patch_kernels();
        SCOPED_TRACE(kernels.name);
        Claims claims;
        Random random(212);
        for (int n = 0; n < 30; ++n) {
            const PatchData patch = random_patch(random, 1 + n % 5, 3, 12, n % 3 == 0 ? 4 : 1);
            const TracedModel model =
                traced_model(ShapeBuilder().face({patch}).model(), 0.5, 0.65, Job{});
            for (int k = 0; k < 150; ++k) {
                const Vec3 target(uniform(random, -55, 55), uniform(random, -55, 55),
                                  uniform(random, -10, 10));
                const Ray ray = ray_through(target + random_direction(random) * 250, Vec3(0));
                Ray aimed = ray;
                aimed.direction = target - ray.origin;
                check_claims(model, kernels, {Vec3(0), 110}, aimed, claims);
            }
        }
        EXPECT_GT(claims.certain, 1000);
        EXPECT_GT(claims.single, 500);
        EXPECT_GT(claims.missed, 10000);
        EXPECT_LT(claims.undecided, claims.certain);
        EXPECT_GT(claims.narrowed, claims.undecided * 9 / 10);
        EXPECT_GT(claims.in_one_box, claims.undecided / 2);
        // Mostly rays that pass the sub-patch just outside; clipping takes over.
        EXPECT_LT(claims.failed, (claims.certain + claims.single) / 50);
    }
}

} // namespace
} // namespace keiko
