#include "keiko/intersect/subpatch/sub_patch.h"

#include "tests/support/exact_patch.h"
#include "tests/support/random_surfaces.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

using namespace test;

/// How far a sub-patch's surface is from the patch it was cut from, over what it says of itself.
/// What moves along the surface alone, by the rounding of where the sub-patch begins and ends, is
/// left out.
double error_of(const SubPatchSet& sub_patches, const SubPatch& sub_patch, const ExactPatch& patch,
                const Vec2& own) {
    const ExactPatch piece(sub_patches.view(sub_patch));
    const Vec2 extent = sub_patch.domain.extent();
    const Long u =
        static_cast<Long>(sub_patch.domain.lower.x) + static_cast<Long>(extent.x) * own.x;
    const Long v =
        static_cast<Long>(sub_patch.domain.lower.y) + static_cast<Long>(extent.y) * own.y;
    const ExactPatch::Point expected = patch.at(u, v);
    const LongVec3 place = piece.at(own.x, own.y).position + lengthened(sub_patch.center);
    const Long along =
        2 * std::numeric_limits<double>::epsilon() * (expected.du.length() + expected.dv.length());
    const Long off = (place - expected.position).length() - along - patch.rounding();
    return static_cast<double>(off) / sub_patch.coefficient_error;
}

struct Case {
    const char* name;
    SurfaceKind kind;
    double reach; ///< mm by which sub-patches go on past the patch's ends
    int faces;
};

void PrintTo(const Case& tested, std::ostream* out) {
    *out << tested.name;
}

class SubPatchRounding : public testing::TestWithParam<Case> {};

TEST_P(SubPatchRounding, KeepsWithinItsBound) {
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
        const SubPatchSet sub_patches =
            subdivide(model, model.faces[0], region, tested.reach, 0.65);
        const ExactPatch patch(model.patch(0));
        for (const SubPatch& sub_patch : sub_patches.sub_patches) {
            if (sub_patch.patch != 0) continue;
            continued = continued || !unit_square.padded(1e-3).contains(sub_patch.domain.lower) ||
                        !unit_square.padded(1e-3).contains(sub_patch.domain.upper);
            for (const Vec2& own : {Vec2(0), Vec2(0.2, 0.9), Vec2(0.5, 0.3), Vec2(1)})
                worst = std::max(worst, error_of(sub_patches, sub_patch, patch, own));
        }
    }
    EXPECT_LT(worst, 1);
    EXPECT_EQ(continued, tested.reach > 0);
    RecordProperty("largest error over bound", std::to_string(worst));
}

TEST(SubPatchNormals, AreNoFartherOffThanBounded) {
    Random random(6);
    double closest = 0;
    for (int i = 0; i < 60; ++i) {
        SurfaceKind kind;
        kind.weights = i % 2 == 1 ? 1.5 : 1;
        const SurfaceModel model = random_face(random, kind);
        const TrimRegion region(model, model.faces[0]);
        const SubPatchSet sub_patches = subdivide(model, model.faces[0], region, 0, 0.65);
        for (const SubPatch& sub_patch : sub_patches.sub_patches)
            for (int k = 0; k < 50 && std::isfinite(sub_patch.normal_spread); ++k) {
                const Vec2 own(uniform(random, 0, 1), uniform(random, 0, 1));
                const SurfaceDerivatives s = evaluate(sub_patches.view(sub_patch), own, 1);
                const Vec3 normal = s.du().cross(s.dv()).normalized();
                const double off = std::min((normal - sub_patch.normal).length(),
                                            (normal + sub_patch.normal).length());
                ASSERT_LE(off, sub_patch.normal_spread + 1e-12) << i;
                closest = std::max(closest, off / sub_patch.normal_spread);
            }
    }
    EXPECT_GT(closest, 0.1);
}

INSTANTIATE_TEST_SUITE_P(
    Faces, SubPatchRounding,
    testing::Values(Case{"Bicubic", {}, 0, 40}, Case{"BicubicContinued", {}, 1, 40},
                    Case{"Weights", {.weights = 1e6}, 0, 40},
                    Case{"WeightsContinued", {.weights = 1e4}, 1, 40},
                    Case{"DegreeTwelve", {.degree_u = 12, .degree_v = 12}, 5, 40},
                    Case{"FarOff", {.offset = Vec3(1e6, -1e6, 1e6)}, 1, 40}),
    [](const auto& tested) { return std::string(tested.param.name); });

} // namespace
} // namespace keiko
