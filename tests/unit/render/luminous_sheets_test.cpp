// Luminous sheets by their contour, held against closed forms and rays.
#include "tests/unit/render/luminous_sheets.h"

#include "keiko/geometry/model/primitive.h"
#include "keiko/light/areas/area_irradiance.h"

#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <array>
#include <numbers>

namespace keiko {
namespace {

using std::numbers::pi;
using test::by_rays, test::lamp_of;

/// The lower half of an ellipsoid's patches: an open bowl.
SurfaceModel bowl(const Vec3& at = {0, 0, 600}) {
    SurfaceModel egg =
        primitive_model(EllipsoidShape{at, {250, 0, 0}, {0, 0, 150}, {0, -200, 30}}, "bowl");
    std::erase_if(egg.patches, [](const Patch& patch) { return patch.map_u.begin >= 3; });
    egg.faces[0].patch_count = static_cast<std::uint32_t>(egg.patches.size());
    return egg;
}

/// The inner side of a pipe is dark, and hides nothing of its outer side.
TEST(LuminousSheets, OuterSideOfAPipeHasTheClosedForm) {
    test::Random random(11);
    for (int i = 0; i < 40; ++i) {
        const Vec3 center = test::random_direction(random) * test::uniform(random, 700, 2500);
        const Vec3 along = test::random_direction(random) * test::uniform(random, 50, 500);
        const double radius = test::uniform(random, 20, 200);
        const double other = i % 2 ? radius : test::uniform(random, 20, 200);
        const Vec3 normal = test::random_direction(random);
        const FrustumShape pipe{center - along, center + along, radius, other, true};
        const FrustumLight side{pipe.from, pipe.to, radius, other, Rgb(1)};
        const ContourLight light = lamp_of(primitive_model(pipe, "pipe"), LampSides::outer_side);
        EXPECT_NEAR(projected_solid_angle(light, Vec3(0), normal),
                    projected_solid_angle(side, Vec3(0), normal), 2e-6 * pi)
            << i;
    }
}

/// Through the open end of a pipe its inner side is seen, which fills what a lid would.
TEST(LuminousSheets, PipeThatShinesBothWaysFillsItsEnds) {
    const FrustumShape can{{100, -300, 900}, {-80, 300, 700}, 60, 90, false};
    FrustumShape pipe = can;
    pipe.open = true;
    const ContourLight closed = lamp_of(primitive_model(can, "can"), LampSides::of_solid);
    const ContourLight open = lamp_of(primitive_model(pipe, "pipe"), LampSides::both_sides);
    for (const Vec3& point : {Vec3(0), Vec3(-700, 200, 100), Vec3(300, 0, 400)})
        EXPECT_NEAR(projected_solid_angle(open, point, {0, 0, 1}),
                    projected_solid_angle(closed, point, {0, 0, 1}), 2e-6);
}

/// From below, from above, from aside and from within.
TEST(LuminousSheets, BowlsShineToTheirSidesAsRaysFind) {
    const std::array<Vec3, 5> points{Vec3(30, 40, 0), Vec3(100, 0, 1200), Vec3(900, -300, 650),
                                     Vec3(-400, 500, 480), Vec3(20, -10, 590)};
    for (const bool reversed : {false, true}) {
        SurfaceModel model = bowl();
        model.faces[0].reversed = reversed;
        SCOPED_TRACE(reversed);
        test::expect_light_of_rays(model, points);
    }
}

/// Outer sides before dark inner ones, and behind them: a ray decides, bowl by bowl.
TEST(LuminousSheets, BowlsOneBeforeTheOtherHideEachOtherAsRaysFind) {
    const std::array<Vec3, 5> points{Vec3(30, 40, 0), Vec3(100, 0, 1700), Vec3(900, -300, 650),
                                     Vec3(-200, 300, 850), Vec3(20, -10, 590)};
    for (const bool reversed : {false, true}) {
        SCOPED_TRACE(reversed);
        std::array both{bowl(), bowl({90, 60, 1000})};
        both[1].faces[0].reversed = reversed;
        test::expect_light_of_rays(merge(both), points);
    }
}

/// A pipe through a plate that shines down: from above it is bright as far as the plate.
TEST(LuminousSheets, SheetsThatPassThroughOneAnotherHideEachOtherAsRaysFind) {
    const FrustumShape pipe{{-40, 0, 350}, {60, 30, 850}, 90, 120, true};
    const PlaneShape plate{{-300, -300, 600}, {0, 600, 0}, {600, 0, 0}};
    const std::array both{primitive_model(pipe, "pipe"), primitive_model(plate, "plate")};
    const std::array<Vec3, 4> points{Vec3(900, -300, 1100), Vec3(-500, 600, 900), Vec3(30, 40, 0),
                                     Vec3(-700, 100, 500)};
    test::expect_light_of_rays(merge(both), points);
}

} // namespace
} // namespace keiko
