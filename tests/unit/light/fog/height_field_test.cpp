#include "keiko/light/fog/height_field.h"

#include <gtest/gtest.h>

#include <random>

using namespace keiko;

TEST(HeightField, NoCrossingIsLost) {
    const HeightField field{.height = 500, .waves = noise_waves(120, 900)};
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-4000, 4000), high(300, 700);
    std::size_t most = 0;
    for (int i = 0; i < 50; ++i) {
        const Segment ray{{place(random), place(random), high(random)},
                          {place(random), place(random), high(random)}};
        const std::vector<double> found = crossings(field, ray);
        for (const double t : found) EXPECT_NEAR(field.above(ray.at(t)), 0, 1e-9);
        // Signs at 5000 places change as often as crossings lie between them.
        double before = field.above(ray.a);
        std::size_t next = 0;
        for (int k = 1; k <= 5000; ++k) {
            const double t = k / 5000.0, now = field.above(ray.at(t));
            std::size_t between = 0;
            while (next < found.size() && found[next] <= t) ++next, ++between;
            EXPECT_EQ(between % 2 == 1, (now < 0) != (before < 0)) << i << " " << t;
            before = now;
        }
        most = std::max(most, found.size());
    }
    EXPECT_GT(most, 5u);
}

TEST(HeightField, NoCrossingOfALongRayThroughShortWavesIsLost) {
    // As far as a ray goes through the steepest and shortest waves that a file may have.
    const HeightField field{.height = 500, .waves = noise_waves(75, 300)};
    const Segment ray{{0, 0, 503}, {1e6, 2e5, 497}};
    const std::vector<double> found = crossings(field, ray);
    std::size_t changes = 0;
    constexpr int places = 1000000;
    bool below = field.above(ray.a) < 0;
    for (int k = 1; k <= places; ++k) {
        const bool now = field.above(ray.at(static_cast<double>(k) / places)) < 0;
        if (now != below) ++changes;
        below = now;
    }
    EXPECT_GE(found.size(), changes);
    EXPECT_LE(static_cast<double>(found.size()), 1.01 * static_cast<double>(changes));
    EXPECT_GT(found.back(), 0.99);
}

TEST(HeightField, AFlatOneIsCrossedOnce) {
    const HeightField flat{.height = 100};
    EXPECT_EQ(crossings(flat, {{0, 0, 0}, {0, 0, 400}}), std::vector<double>{0.25});
    EXPECT_TRUE(crossings(flat, {{0, 0, 0}, {1, 0, 0}}).empty());
    EXPECT_TRUE(crossings(flat, {{0, 0, 100}, {1, 0, 100}}).empty());
    EXPECT_TRUE(crossings(flat, {{0, 0, 101}, {1, 0, 400}}).empty());
}

TEST(HeightField, ARayInTheSurfaceEnds) {
    // Along the nodes of the waves, at their level.
    const HeightField field{.height = 500, .waves = {Wave{100, {900, 700}, {0, 0}}}};
    const Segment ray{{-1e6, 0, 500}, {1e6, 0, 500}};
    for (const double t : crossings(field, ray)) EXPECT_NEAR(field.above(ray.at(t)), 0, 1e-9);
    EXPECT_TRUE(crossings(field, {{1, 2, 500}, {1, 2, 500}}).size() <= 1);
}
