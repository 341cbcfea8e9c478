#include "tests/bench/penumbra_methods.h"
#include <gtest/gtest.h>

#include <algorithm>

namespace keiko::bench {
namespace {

const PenumbraScene& sheet() {
    static const PenumbraScene scene("sheet", wavy_sheet(4, 4), 0.3, 3, 200);
    return scene;
}

TEST(PenumbraMethods, AgreeOnThinLamps) {
    const Shares exact = by_intervals(sheet(), sheet().row);
    const auto off = [&](int rays) {
        return rms(by_samples(sheet(), sheet().row, Emitter::axis, {rays, 1}), exact);
    };
    EXPECT_GT(off(8), 1e-3);
    EXPECT_LT(off(1024), 5e-4);
}

TEST(PenumbraMethods, AgreeOnLampsWithWidth) {
    const Shares exact = by_width(sheet(), sheet().row, 1e-6);
    EXPECT_LT(rms(by_width(sheet(), sheet().row, 1e-3), exact), 1e-3);
    EXPECT_LT(rms(by_samples(sheet(), sheet().row, Emitter::rectangle, {256, 4}), exact), 5e-4);
}

TEST(PenumbraMethods, LookAtLampsThatAreHiddenInPart) {
    const Shares exact = by_intervals(sheet(), sheet().row);
    EXPECT_GT(std::count_if(exact.values.begin(), exact.values.end(),
                            [](double share) { return share > 0.01 && share < 0.99; }),
              8);
    const WrongLamps count = wrong_lamps(sheet(), sheet().row, 200);
    EXPECT_EQ(count.wrong, 0u);
    EXPECT_GT(count.probes, 10'000u);
}

TEST(WavySheet, IsNearlyTheSameSurfaceInMorePatches) {
    const Tracer coarse(wavy_sheet(8, 8)), fine(wavy_sheet(32, 32));
    for (const double x : {130.0, 480.0, 770.0}) {
        Ray ray;
        ray.origin = {x, 310, 1000};
        ray.direction = {0, 0, -1};
        const auto a = coarse.nearest(ray), b = fine.nearest(ray);
        ASSERT_TRUE(a && b);
        EXPECT_NEAR(a->position.z, b->position.z, 1);
        EXPECT_GT(std::abs(a->position.z), 1);
    }
}

} // namespace
} // namespace keiko::bench
