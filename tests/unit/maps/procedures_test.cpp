// The procedures of the oracle, and how noise fades with the pixel.
#include "keiko/maps/lattice_noise.h"
#include "keiko/maps/orange_peel.h"
#include "keiko/maps/patterns.h"
#include "keiko/maps/reaction_diffusion.h"
#include "keiko/maps/voronoi.h"

#include "tests/support/oracle.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace keiko {
namespace {

using test::OracleRow;
using test::OracleTable;

TEST(Procedures, ValuesAreTheOracles) {
    const OracleTable table("procedural");
    ASSERT_EQ(table.size(), 14U);
    constexpr double tolerance = 1e-12;
    for (const OracleRow& row : table) {
        const Vec3 at(row.number("in.x"), row.number("in.y"), row.number("in.z"));
        const auto seed = static_cast<std::uint32_t>(std::stoul(row.text("in.seed")));
        const NoiseOctaves octaves{seed, row.integer("in.oct"), row.number("in.gain"),
                                   row.number("in.lac")};
        const TexturePlace place{at};
        const auto cell = [](double x) { return static_cast<std::int32_t>(std::floor(x)); };
        EXPECT_EQ(lattice_hash(cell(at.x), cell(at.y), cell(at.z), seed),
                  std::stoul(row.text("out.hash0")))
            << row.id();
        EXPECT_NEAR(lattice_noise(at, seed), row.number("out.noise"), tolerance) << row.id();
        EXPECT_NEAR(fractal_noise(at, octaves, 0), row.number("out.fractal"), tolerance);
        EXPECT_NEAR(turbulence(at, octaves, 0), row.number("out.turb"), tolerance);
        const double amp = row.number("in.amp");
        EXPECT_NEAR(marble(place, amp, octaves), row.number("out.marble"), tolerance) << row.id();
        EXPECT_NEAR(wood(place, amp, seed), row.number("out.wood"), tolerance) << row.id();
        EXPECT_EQ(std::floor(wood_radius(at, amp, seed)), row.number("out.ring")) << row.id();
        EXPECT_EQ(checker(place), row.number("out.checker")) << row.id();
        const BrickBond bond{row.number("in.bw"), row.number("in.bh"), row.number("in.mw")};
        const BrickPlace brick = brick_at(at, bond);
        EXPECT_EQ(brick.row, row.number("out.row")) << row.id();
        EXPECT_EQ(brick.column, row.number("out.colb")) << row.id();
        EXPECT_EQ(bricks(place, bond), row.number("out.is_brick")) << row.id();
    }
}

/// Mean of a function over 10^5 random places.
template <class Value>
double mean(const Value& value) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-500, 500);
    double sum = 0;
    constexpr int count = 100000;
    for (int i = 0; i < count; ++i) sum += value(Vec3(place(random), place(random), place(random)));
    return sum / count;
}

TEST(Procedures, WidePixelsShowTheMean) {
    const Vec3 wide(3, 0, 0), tall(0, 3, 0);
    const NoiseOctaves octaves{5, 4, 0.5, 2};
    EXPECT_EQ(fractal_noise(Vec3(0.3), octaves, 3), 0);
    EXPECT_NEAR(turbulence(Vec3(0.3), octaves, 3),
                mean([&](const Vec3& p) { return turbulence(p, octaves, 0); }), 2e-3);
    for (const VoronoiValue value :
         {VoronoiValue::distance, VoronoiValue::ridge, VoronoiValue::cell})
        EXPECT_NEAR(voronoi({Vec3(0.3), wide, tall}, value, 5),
                    mean([&](const Vec3& p) { return voronoi({p}, value, 5); }), 3e-3);
}

TEST(Procedures, OctavesFadeOneByOne) {
    const Vec3 at(0.37, 1.41, -2.2);
    const NoiseOctaves all{9, 3, 0.5, 2};
    EXPECT_DOUBLE_EQ(fractal_noise(at, all, 0.3), // half of a cell is 0.5 and 0.25 and 0.125
                     fractal_noise(at, {9, 1, 0.5, 2}, 0) +
                         0.5 * octave_share(0.6) * lattice_noise(at * 2.0, 9));
}

TEST(Procedures, VoronoiFindsTheNearestOfAllPoints) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-3, 3);
    constexpr std::uint32_t seed = 11;
    for (int trial = 0; trial < 300; ++trial) {
        const Vec3 at(place(random), place(random), place(random));
        double nearest = std::numeric_limits<double>::infinity(), next = nearest;
        for (int i = -9; i <= 9; ++i)
            for (int j = -9; j <= 9; ++j)
                for (int k = -9; k <= 9; ++k) {
                    const auto share = [&](std::uint32_t axis) {
                        return lattice_hash(i, j, k, 4 * seed + axis) / 4294967296.0;
                    };
                    const double d = (Vec3(i + share(1), j + share(2), k + share(3)) - at).length();
                    if (d < nearest)
                        next = nearest, nearest = d;
                    else
                        next = std::min(next, d);
                }
        const VoronoiPoints found = voronoi_points(at, seed);
        EXPECT_NEAR(found.nearest, nearest, 1e-14);
        EXPECT_NEAR(found.next, next, 1e-14);
    }
}

TEST(Procedures, ReactionDiffusionLeavesAPatternOfItsSeed) {
    const Image pattern = reaction_diffusion(0.037, 0.06, 1);
    const auto share = [](const Image& image) {
        const auto high = std::count_if(image.values.begin(), image.values.end(),
                                        [](float v) { return v > 0.5F; });
        return static_cast<double>(high) / static_cast<double>(image.values.size());
    };
    EXPECT_GT(share(pattern), 0.2);
    EXPECT_LT(share(pattern), 0.8);
    EXPECT_EQ(*std::max_element(pattern.values.begin(), pattern.values.end()), 1.0F);
    EXPECT_EQ(pattern.values, reaction_diffusion(0.037, 0.06, 1).values);
    EXPECT_NE(pattern.values, reaction_diffusion(0.037, 0.06, 2).values);
    EXPECT_EQ(share(reaction_diffusion(0.1, 0.1, 1)), 0) << "dies out";
}

} // namespace
} // namespace keiko
