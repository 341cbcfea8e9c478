#include "keiko/inspect/basics/patch_box.h"

#include "tests/support/analytic_models.h"
#include "tests/support/random.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

/// A box of the patch reached by random halvings.
PatchBox random_box(const BezierPatchView& patch, int cuts, test::Random& random) {
    PatchBox box(patch);
    for (int i = 0; i < cuts; ++i)
        box = box.halves(test::pick(random, 2) == 0)[test::pick(random, 2)];
    return box;
}

Vec2 at(const Box2& box, double x, double y) {
    return box.lower + Vec2(x, y) * box.extent();
}

std::vector<SurfaceModel> models() {
    return {test::bonnet_model(1200, 1400, 80),
            test::sphere_model(test::stretched({400, 500, 600}, {0.1, 0.2, 1}, {900, -20, 50}))};
}

TEST(PatchBox, IsThePatchOverItsParameters) {
    test::Random random(7);
    for (const SurfaceModel& model : models())
        for (int i = 0; i < 200; ++i) {
            const BezierPatchView patch =
                model.patch(static_cast<std::uint32_t>(test::pick(random, model.patches.size())));
            const PatchBox box = random_box(patch, i % 12, random);
            const double x = test::uniform(random, 0, 1), y = test::uniform(random, 0, 1);
            const Vec3 exact = evaluate(patch, at(box.uv(), x, y), 0).position();
            const Vec3 place = evaluate(box.view(), {x, y}, 0).position();
            EXPECT_LE((place - exact).length(), 1e-10);
        }
}

} // namespace
} // namespace keiko
