#include "keiko/intersect/subpatch/leaf.h"

#include "tests/support/exact_patch.h"
#include "tests/support/random_surfaces.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

using namespace test;

/// How far a leaf's surface is from the patch it was cut from, over what it says of itself. What
/// moves along the surface alone, by the rounding of where the leaf begins and ends, is left out.
double error_of(const LeafSet& leaves, const Leaf& leaf, const ExactPatch& patch, const Vec2& own) {
    const ExactPatch piece(leaves.view(leaf));
    const Vec2 extent = leaf.domain.extent();
    const Long u = static_cast<Long>(leaf.domain.lower.x) + static_cast<Long>(extent.x) * own.x;
    const Long v = static_cast<Long>(leaf.domain.lower.y) + static_cast<Long>(extent.y) * own.y;
    const ExactPatch::Point expected = patch.at(u, v);
    const LongVec3 place = piece.at(own.x, own.y).position + lengthened(leaf.center);
    const Long along =
        2 * std::numeric_limits<double>::epsilon() * (expected.du.length() + expected.dv.length());
    const Long off = (place - expected.position).length() - along - patch.rounding();
    return static_cast<double>(off) / leaf.coefficient_error;
}

struct Case {
    const char* name;
    SurfaceKind kind;
    double reach; ///< mm by which leaves go on past the patch's ends
    int faces;
};

void PrintTo(const Case& tested, std::ostream* out) {
    *out << tested.name;
}

class LeafRounding : public testing::TestWithParam<Case> {};

TEST_P(LeafRounding, KeepsWithinItsBound) {
    const Case& tested = GetParam();
    Random random(5);
    double worst = 0;
    bool continued = false;
    for (int i = 0; i < tested.faces; ++i) {
        SurfaceKind kind = tested.kind;
        kind.trimmed = true;
        const SurfaceModel model = random_face(random, kind);
        const std::vector<double> widths(model.trim_curves.size(), 0.0);
        const TrimRegion region(model, model.faces[0], widths);
        const LeafSet leaves = make_leaves(model, model.faces[0], region, tested.reach, 0.65);
        const ExactPatch patch(model.patch(0));
        for (const Leaf& leaf : leaves.leaves) {
            if (leaf.patch != 0) continue;
            continued = continued || !unit_square.padded(1e-3).contains(leaf.domain.lower) ||
                        !unit_square.padded(1e-3).contains(leaf.domain.upper);
            for (const Vec2& own : {Vec2(0), Vec2(0.2, 0.9), Vec2(0.5, 0.3), Vec2(1)})
                worst = std::max(worst, error_of(leaves, leaf, patch, own));
        }
    }
    EXPECT_LT(worst, 1);
    EXPECT_EQ(continued, tested.reach > 0);
    RecordProperty("largest error over bound", std::to_string(worst));
}

TEST(LeafNormals, AreNoFartherOffThanBounded) {
    Random random(6);
    double closest = 0;
    for (int i = 0; i < 60; ++i) {
        SurfaceKind kind;
        kind.weights = i % 2 == 1 ? 1.5 : 1;
        const SurfaceModel model = random_face(random, kind);
        const TrimRegion region(model, model.faces[0]);
        const LeafSet leaves = make_leaves(model, model.faces[0], region, 0, 0.65);
        for (const Leaf& leaf : leaves.leaves)
            for (int k = 0; k < 50 && std::isfinite(leaf.normal_spread); ++k) {
                const Vec2 own(uniform(random, 0, 1), uniform(random, 0, 1));
                const SurfaceDerivatives s = evaluate(leaves.view(leaf), own, 1);
                const Vec3 normal = s.du().cross(s.dv()).normalized();
                const double off =
                    std::min((normal - leaf.normal).length(), (normal + leaf.normal).length());
                ASSERT_LE(off, leaf.normal_spread + 1e-12) << i;
                closest = std::max(closest, off / leaf.normal_spread);
            }
    }
    EXPECT_GT(closest, 0.1);
}

INSTANTIATE_TEST_SUITE_P(
    Faces, LeafRounding,
    testing::Values(Case{"Bicubic", {}, 0, 40}, Case{"BicubicContinued", {}, 1, 40},
                    Case{"Weights", {.weights = 1e6}, 0, 40},
                    Case{"WeightsContinued", {.weights = 1e4}, 1, 40},
                    Case{"DegreeTwelve", {.degree_u = 12, .degree_v = 12}, 5, 40},
                    Case{"FarOff", {.offset = Vec3(1e6, -1e6, 1e6)}, 1, 40}),
    [](const auto& tested) { return std::string(tested.param.name); });

} // namespace
} // namespace keiko
