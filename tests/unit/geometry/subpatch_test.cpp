#include "keiko/geometry/bezier/subpatch.h"

#include "keiko/geometry/bezier/bezier.h"

#include "tests/support/random_patches.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

using namespace test;

/// A seam's reach continues the last sliver of a cropped patch by many times its own width; the
/// rounding of that must stay what it is for the whole patch.
TEST(Subpatch, ContinuedFromASliverStaysAsExactAsFromTheWhole) {
    Random random(7);
    for (const int degree : {3, 9, 25}) {
        const PatchData patch = random_patch(random, degree, degree, 20, 1);
        const BezierPatchView whole{degree, degree, patch.points};
        for (const double sliver : {0.02, 6e-4, 1e-6}) {
            const Box2 low{Vec2(-0.01), Vec2(sliver)}, high{Vec2(1 - sliver), Vec2(1.01)};
            for (const Box2& box : {low, high}) {
                const std::vector<Vec4> points = subpatch(whole, box);
                const BezierPatchView part{degree, degree, points};
                for (const Vec2& own : {Vec2(0), Vec2(0.3, 0.8), Vec2(1)}) {
                    const Vec2 uv = box.lower + box.extent() * own;
                    const Vec3 expected = evaluate(whole, uv, 0).position();
                    EXPECT_LT((evaluate(part, own, 0).position() - expected).length(), 1e-11)
                        << degree << ' ' << sliver;
                }
            }
        }
    }
}

} // namespace
} // namespace keiko
