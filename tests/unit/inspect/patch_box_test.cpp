#include "keiko/inspect/basics/patch_box.h"

#include "keiko/inspect/basics/line_field.h"

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

bool holds(const Interval& range, double value) {
    return range.low <= value && value <= range.high;
}

Triple<FirstJet> jet_of(const SurfaceDerivatives& s, std::size_t k, std::size_t l,
                        const Vec2& step) {
    const double scale = std::pow(step.x, double(k)) * std::pow(step.y, double(l));
    const auto axis = [&](int i) {
        return FirstJet(s.d[k][l][i] * scale, s.d[k + 1][l][i] * scale * step.x,
                        s.d[k][l + 1][i] * scale * step.y);
    };
    return {axis(0), axis(1), axis(2)};
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
            const auto values = box.values(x, y).place;
            EXPECT_NEAR(values.x.middle(), exact.x, 1e-10);
            EXPECT_NEAR(values.y.middle(), exact.y, 1e-10);
            EXPECT_NEAR(values.z.middle(), exact.z, 1e-10);
        }
}

/// The search for lines rests on this: no value and no slope of the field leaves its bounds.
TEST(PatchBox, BoundsOfEveryFieldHoldItsValuesAndSlopes) {
    test::Random random(8);
    CPlane lamps;
    lamps.origin = {-2000, -2000, 2500}, lamps.u = {4000, 100, 0}, lamps.v = {-100, 4000, 300};
    Camera camera;
    for (const SurfaceModel& model : models())
        for (int i = 0; i < 300; ++i) {
            const BezierPatchView patch =
                model.patch(static_cast<std::uint32_t>(test::pick(random, model.patches.size())));
            const PatchBox box = random_box(patch, i % 12, random);
            const Vec2 uv = at(box.uv(), test::uniform(random, 0, 1), test::uniform(random, 0, 1));
            const SurfaceDerivatives s = evaluate(patch, uv, 2);
            const Vec2 step = box.uv().extent();
            const PatchBox::Ranges ranges = box.ranges();
            for (const LineLook look :
                 {LineLook::reflection, LineLook::highlight, LineLook::isophote}) {
                const LineField field(look, LineEye(camera), lamps, Vec3(0));
                const auto bounds =
                    field.ratio(ranges.place, cross(ranges.dx, ranges.dy), 0.5).residual(0.25);
                const auto value =
                    field
                        .ratio(jet_of(s, 0, 0, step),
                               cross(jet_of(s, 1, 0, step), jet_of(s, 0, 1, step)), 0.5)
                        .residual(0.25);
                EXPECT_TRUE(holds(bounds.f, value.f)) << name_of(look);
                EXPECT_TRUE(holds(bounds.u, value.u)) << name_of(look);
                EXPECT_TRUE(holds(bounds.v, value.v)) << name_of(look);
            }
        }
}

} // namespace
} // namespace keiko
