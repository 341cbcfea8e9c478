#include "tests/bench/penumbra_scene.h"
#include "tests/bench/stripe_methods.h"
#include <gtest/gtest.h>

#include <algorithm>

namespace keiko::bench {
namespace {

/// A gentle wave, seen from above at an angle.
StripeScene small_scene() {
    Camera camera;
    camera.eye = {500, -1500, 1400};
    camera.target = {500, 500, 0};
    camera.vertical_fov = 30;
    camera.width = 48, camera.height = 27;
    return {"sheet", wavy_sheet(2, 2), camera};
}

TEST(Stripes, OfOneRayWithItsFootprintAreThoseOfManyRays) {
    const StripeScene scene = small_scene();
    const Film truth = supersampled(scene, 16, true), drawn = with_footprints(scene, 8);
    const std::vector<bool> every(48 * 27, true);
    const double off = display_rms(drawn, truth, every);
    EXPECT_LT(off, 3.0 / 255);
    EXPECT_LT(6 * off, display_rms(supersampled(scene, 1, false), truth, every));
}

TEST(Stripes, AreTheSameInTheMeanWithFootprintsAndWithout) {
    const StripeScene scene = small_scene();
    const std::vector<bool> every(48 * 27, true);
    EXPECT_LT(display_rms(supersampled(scene, 16, false), supersampled(scene, 16, true), every),
              2.0 / 255);
}

TEST(Stripes, GetOneRayInMostPixels) {
    const StripeScene scene = small_scene();
    const auto single = same_pixels(with_footprints(scene, 1), with_footprints(scene, 8));
    EXPECT_GT(std::count(single.begin(), single.end(), true), 48 * 27 / 2);
}

} // namespace
} // namespace keiko::bench
