#include "keiko/light/rig/luminance_along.h"

#include <gtest/gtest.h>

using namespace keiko;

namespace {

LightRig foggy(LightSource source) {
    return {.name = "",
            .sources = {std::move(source)},
            .ambient = Rgb(0),
            .medium = Medium{.extinction = Rgb(0.1, 0.2, 0.1), .albedo = Rgb(0.5)}};
}

const Vec3 place(0, 0, 0), eye(0, -6000, 0), lamp(0, 0, 4000);

} // namespace

TEST(MultipleScattering, CountsBothLegsOfTheThickestChannel) {
    EXPECT_NEAR(scatterings_by_way_of(foggy(Spotlight{.position = lamp}), place, eye),
                0.5 * 0.2 * (4 + 6), 1e-12);
}

TEST(MultipleScattering, CountsLightBehindWindowsFromThePlaceOn) {
    const Sun sun{.windows = {Window{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}}};
    EXPECT_NEAR(scatterings_by_way_of(foggy(sun), place, eye), 0.5 * 0.2 * 6, 1e-12);
}

TEST(MultipleScattering, IsNoneWhereNoLampLightsTheMedium) {
    EXPECT_EQ(scatterings_by_way_of(foggy(Spotlight{.position = lamp, .shaft = false}), place, eye),
              0);
    EXPECT_EQ(scatterings_by_way_of(foggy(Sun{}), place, eye), 0);
    EXPECT_EQ(scatterings_by_way_of(foggy(CPlane{}), place, eye), 0);
    LightRig clear = foggy(Spotlight{.position = lamp});
    clear.medium.reset();
    EXPECT_EQ(scatterings_by_way_of(clear, place, eye), 0);
}
