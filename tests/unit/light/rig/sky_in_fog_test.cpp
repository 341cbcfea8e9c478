#include "keiko/light/rig/luminance_along.h"
#include "keiko/light/rig/surface_light.h"
#include "keiko/light/sky/sky_scattering.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

constexpr double pi = std::numbers::pi;
const Vec3 up(0, 0, 1), here(0);

/// A sky over fog of 2/m that is 300 mm deep, with clear air above.
LightRig rig_of(const SkyLight& sky) {
    LightRig rig;
    rig.sources = {sky};
    rig.medium.emplace();
    rig.medium->extinction = Rgb(2), rig.medium->albedo = Rgb(0.8);
    rig.medium->density = LayeredDensity{{300, {}}, Rgb(0)};
    return rig;
}

/// Level ground at an optical depth t has 2 pi L E3(t) of a uniform sky, and of one that is linear
/// in the height a share of E4(t).
TEST(SkyInFog, GroundBelowALayerMeetsTheExponentialIntegrals) {
    const double t = 0.6, e2 = std::exp(-t) + t * std::expint(-t);
    const double e3 = (std::exp(-t) - t * e2) / 2, e4 = (std::exp(-t) - t * e3) / 3;
    const auto lx = [](SkyModel model) {
        return direct_illuminance(rig_of({model, Rgb(100)}), here, up, Unoccluded()).g;
    };
    EXPECT_NEAR(lx(SkyModel::uniform), 200 * pi * e3, 1e-3 * 200 * pi * e3);
    const double overcast = 200 * pi * (e3 / 3 + e4 * 2 / 3);
    EXPECT_NEAR(lx(SkyModel::overcast), overcast, 1e-3 * overcast);
}

/// A narrow lobe shows the sky dimmed by the way in its direction.
TEST(SkyInFog, LobeShowsTheSkyDimmedInItsDirection) {
    const Gloss gloss{.distribution = {DistributionKind::phong, 4000}};
    const Vec3 eye = Vec3(-1, 0, 0.75).normalized();
    const GlossKernel kernel(gloss, up, eye);
    const double dimmed = std::exp(-0.6 / eye.z), clear = 100 * gloss.reflectance(eye.z).g;
    const LightRig rig = rig_of({SkyModel::uniform, Rgb(100)});
    EXPECT_NEAR(glossy_luminance(rig, here, kernel, Unoccluded()).g, clear * dimmed, 3e-3 * clear);
}

/// Light of the open sky along a camera ray; through a window it lights no fog.
TEST(SkyInFog, OpenSkyLightsTheFogAlongARay) {
    SkyLight sky{SkyModel::overcast, Rgb(100)};
    const Segment ray{{0, 0, 100}, {900, 300, 250}};
    const LightRig open = rig_of(sky);
    const Rgb along = luminance_along(open, ray, Rgb(0), {}, 1e-4);
    EXPECT_EQ(along, scattered_light(AttenuatedRay(*open.medium, ray), sky, 1e-4));
    EXPECT_GT(along.g, 1);
    sky.windows = {{{{500, -500, 0}, {500, 500, 0}, {500, 500, 900}, {500, -500, 900}}}};
    EXPECT_EQ(luminance_along(rig_of(sky), ray, Rgb(0), {}, 1e-4), Rgb(0));
}

} // namespace
} // namespace keiko
