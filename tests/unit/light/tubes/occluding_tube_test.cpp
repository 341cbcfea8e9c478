#include "keiko/light/tubes/cylinder_irradiance.h"
#include "keiko/math/interval_set.h"

#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace keiko;

namespace {

/// True if a ray from (0, 0) in a plane parallel to the axis of a capped tube meets it. The slab of
/// distances within which the plane is inside of the endless tube is held against that between its
/// ends.
bool meets(double radius, double begin, double end, double across, double middle, double eta) {
    const double half = std::sqrt(radius * radius - across * across);
    // Marched in fine steps of the distance along the half-plane.
    constexpr int steps = 4000;
    for (int i = 0; i <= steps; ++i) {
        const double r = middle - half + 2 * half * i / steps, x = r * std::tan(eta);
        if (x >= begin && x <= end) return true;
    }
    return false;
}

} // namespace

TEST(HiddenElevations, AreThoseOfRaysThatMeetTheTube) {
    test::Random random(5);
    int hidden = 0, open = 0;
    for (int i = 0; i < 400; ++i) {
        TubeView view;
        view.radius = test::uniform(random, 5, 80);
        view.x_a = test::uniform(random, -2000, 800);
        view.length = test::uniform(random, 50, 2500);
        const OccludingTube tube{test::uniform(random, 1.05, 30) * view.radius,
                                 test::uniform(random, -0.3, 0.3)};
        const double half = std::asin(view.radius / tube.distance);
        const double psi = tube.angle + half * test::uniform(random, -1.2, 1.2);
        const double near = test::uniform(random, 0.5, 3) * tube.distance;
        const auto found = hidden_elevations(view, std::array{tube}, psi, near);
        const double across = tube.distance * std::sin(psi - tube.angle);
        const double middle = tube.distance * std::cos(psi - tube.angle);
        const bool crossed = std::abs(across) < view.radius;
        if (!crossed) {
            EXPECT_TRUE(found.empty());
            continue;
        }
        const double front = middle - std::sqrt(view.radius * view.radius - across * across);
        ASSERT_EQ(found.size(), front < near ? 1U : 0U) << "only what lies nearer hides";
        if (found.empty()) continue;
        const double begin = 2 * std::atan(found[0].begin), end = 2 * std::atan(found[0].end);
        for (int k = 0; k < 20; ++k) {
            const double eta = test::uniform(random, -1.5, 1.5);
            // Steps of the march are coarse beside an end.
            if (std::min(std::abs(eta - begin), std::abs(eta - end)) < 1e-3) continue;
            const bool inside = eta > begin && eta < end;
            EXPECT_EQ(meets(view.radius, view.x_a, view.x_a + view.length, across, middle, eta),
                      inside);
            (inside ? hidden : open) += 1;
        }
    }
    EXPECT_GT(hidden, 500);
    EXPECT_GT(open, 500);
}

TEST(HiddenElevations, ATubeBehindThePointHidesNothing) {
    TubeView view;
    view.radius = 20;
    view.x_a = -500;
    view.length = 1000;
    const OccludingTube behind{300, 3.1};
    EXPECT_TRUE(hidden_elevations(view, std::array{behind}, 0, 1000).empty());
}
