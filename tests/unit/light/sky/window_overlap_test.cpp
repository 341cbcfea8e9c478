#include "keiko/light/sky/window_overlap.h"

#include "keiko/light/sky/sky_irradiance.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace keiko {
namespace {

const Vec3 here(0), ahead = Vec3(1, 0.1, 0.2).normalized();

/// An upright rectangle across x.
Window pane(double x, double left, double right, double low, double high) {
    return {{{x, left, low}, {x, right, low}, {x, right, high}, {x, left, high}}};
}

SkyLight behind(std::vector<Window> windows) {
    SkyLight sky{SkyModel::overcast, Rgb(1)};
    sky.windows = std::move(windows);
    return sky;
}

double illuminance(const SkyLight& sky, double tolerance) {
    double sum = 0;
    for (int i = 0; i < panel_count(sky); ++i)
        if (const auto panel = sky_panel(sky, i, here))
            sum += illuminance_from(sky, *panel, here, ahead).g *
                   visible_share(sky, *panel, here, ahead, Unoccluded(), {tolerance, 0.12, true});
    return sum;
}

/// The closed forms of both, less that of the part that they share, in the plane of the first.
TEST(WindowOverlap, SharedDirectionsCountOnce) {
    const Window near = pane(1000, -400, 500, 100, 900);
    const double first = illuminance(behind({near}), 1e-7);
    for (const double shift : {-3000.0, -700.0, 0.0, 250.0, 1500.0, 2500.0}) {
        const Window far = pane(2000, shift - 500, shift + 500, 500, 1500);
        const double low = std::max(-400.0, shift / 2 - 250);
        const double high = std::min(500.0, shift / 2 + 250);
        const double both =
            low < high ? illuminance(behind({pane(1000, low, high, 250, 750)}), 1e-7) : 0;
        const double all = first + illuminance(behind({far}), 1e-7) - both;
        EXPECT_NEAR(illuminance(behind({near, far}), 5e-5), all, 1e-4 * all) << shift;
        EXPECT_NEAR(illuminance(behind({far, near}), 1e-7), all, 1e-6 * all) << shift;
    }
}

/// A window that shows nothing of its own, and a third beside both.
TEST(WindowOverlap, WindowBehindAnotherAddsNothing) {
    const Window near = pane(1000, -400, 500, 100, 900), inside = pane(3000, -300, 300, 900, 1500);
    const Window beside = pane(1000, 700, 900, 100, 900);
    const double both = illuminance(behind({near, beside}), 1e-7);
    EXPECT_NEAR(illuminance(behind({near, inside, beside}), 1e-7), both, 1e-7);
    EXPECT_GT(both, illuminance(behind({near}), 1e-7) + 1e-3);
}

/// A concave window leaves its notch to the one behind it.
TEST(WindowOverlap, NotchOfAWindowShowsTheOneBehind) {
    const Window notched{{{1000, -400, 100},
                          {1000, 500, 100},
                          {1000, 500, 900},
                          {1000, 200, 900},
                          {1000, 200, 400},
                          {1000, -100, 400},
                          {1000, -100, 900},
                          {1000, -400, 900}}};
    const double whole = illuminance(behind({pane(1000, -400, 500, 100, 900)}), 1e-7);
    const SkyLight sky = behind({notched, pane(2000, -800, 1000, 200, 1800)});
    EXPECT_NEAR(illuminance(sky, 1e-7), whole, 1e-6 * whole);
}

} // namespace
} // namespace keiko
