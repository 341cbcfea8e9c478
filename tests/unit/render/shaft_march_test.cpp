#include "keiko/import/worker/load_model.h"

#include "tests/support/paths.h"
#include "tests/support/shaft_trial.h"
#include <gtest/gtest.h>

#include <algorithm>

using namespace keiko;

/// Marching knows nothing of silhouettes, intervals or quadrature: only its shadow rays are
/// Keiko's.
TEST(Shafts, AreWhatMarchingWithShadowRaysComesTo) {
    const test::ShaftTrial trial(load_model(test::repository("surfaces/dome.bpt")), 3);
    const std::vector<Segment> rays = trial.camera_rays(Vec2(0.47, 0.62), 8);
    const std::vector<Rgb> exact = trial.exact(rays, 1e-8);
    const std::vector<Rgb> shown = trial.exact(rays, 1e-5, trial.pencils());
    double brightest = 0, cut = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!(exact[i].g > 0)) continue;
        EXPECT_NEAR(shown[i].g, exact[i].g, 1e-5 * exact[i].g) << i;
        brightest = std::max(brightest, exact[i].g);
        for (const auto marching : {test::Marching::even, test::Marching::equi_angular}) {
            const double coarse = trial.marched(rays[i], 250, marching).g;
            const double fine = trial.marched(rays[i], 16000, marching).g;
            EXPECT_NEAR(fine, exact[i].g, 1e-3 * exact[i].g) << i;
            cut = std::max(cut, std::abs(coarse / exact[i].g - 1));
        }
    }
    EXPECT_GT(brightest, 0);
    // Coarse steps miss by more: there are shadows to be missed.
    EXPECT_GT(cut, 1e-3);
}
