#include "keiko/texels/fibre_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace keiko {
namespace {

/// Sum of the extinctions over the voxels of a level, times their volume.
double total(const TexelBlock& block, int level) {
    const auto [wide, deep, high] = block.voxels();
    const int side = wide >> level, layers = high >> level;
    double sum = 0;
    for (int k = 0; k < layers; ++k)
        for (int j = 0; j < side; ++j)
            for (int i = 0; i < side; ++i)
                sum += block.at(Vec3((i + 0.5) / side, (j + 0.5) / side, (k + 0.5) / layers), level)
                           .extinction;
    const Vec3& size = block.size();
    return sum * size.x * size.y * size.z / (1.0 * side * side * layers);
}

TEST(FibreBlock, OfFurHidesTheWidthTimesTheLengthOfItsHairs) {
    TexelSpec spec;
    spec.thickness = 12, spec.voxels = 32;
    spec.fibres = FurSpec{.hairs = 100, .length = 10, .variation = 0, .width = 0.05, .block = 16};
    const TexelBlock block = fibre_block(spec);
    const double hairs = 256; // 16 mm x 16 mm
    // Roots lose the share that their lowest voxel would give to one below the block.
    const double voxel = block.size().z / block.voxels()[2];
    const double expected = hairs * 10 * 0.05;
    EXPECT_NEAR(total(block, 0), expected, hairs * voxel * 0.05 / 4);
    for (int level = 1; level <= block.coarsest(); ++level)
        EXPECT_NEAR(total(block, level), total(block, 0), 1e-4 * expected) << level;
}

TEST(FibreBlock, OfCurledFurHidesAsMuchAsItsHelicesAreLong) {
    TexelSpec spec;
    spec.thickness = 12, spec.voxels = 32;
    spec.fibres = FurSpec{.hairs = 100,
                          .length = 10,
                          .variation = 0,
                          .width = 0.05,
                          .lean = 0,
                          .droop = 0,
                          .curl_radius = 1,
                          .curl_turns = 20,
                          .block = 16};
    constexpr int steps = 100000;
    double length = 0; // of a helix that opens over its first fifth
    for (int i = 0; i < steps; ++i) {
        const double share = (i + 0.5) / steps, radius = std::min(1.0, 5 * share);
        const double around = 2 * std::numbers::pi * 20 * radius, out = share < 0.2 ? 5 : 0;
        length += std::sqrt(10 * 10 + around * around + out * out) / steps;
    }
    const double expected = 256 * length * 0.05;
    EXPECT_NEAR(total(fibre_block(spec), 0), expected, 0.005 * expected);
}

TEST(FibreBlock, HasTheStatedNumberOfHairsRoundedToAWholeOne) {
    for (const auto& [hairs, laid] : {std::pair(60.0, 240), {2.4, 10}, {0.25, 1}}) {
        TexelSpec spec;
        spec.thickness = 12, spec.voxels = 32;
        spec.fibres =
            FurSpec{.hairs = hairs, .length = 10, .variation = 0, .width = 0.05, .block = 20};
        const TexelBlock block = fibre_block(spec);
        const double voxel = block.size().z / block.voxels()[2];
        EXPECT_NEAR(total(block, 0) / (10 * 0.05), laid, laid * voxel / 4 / 10) << hairs;
    }
}

TEST(FibreBlock, RepeatsAndKeepsItsSeed) {
    TexelSpec spec;
    spec.voxels = 16;
    const TexelBlock block = fibre_block(spec), again = fibre_block(spec);
    spec.seed = 2;
    const TexelBlock other = fibre_block(spec);
    double difference = 0;
    for (const Vec3& place : {Vec3(0.1, 0.7, 0.3), Vec3(0.99, 0.01, 0.5), Vec3(0.5, 0.5, 0.1)}) {
        const double here = block.at(place, 0).extinction;
        EXPECT_EQ(here, again.at(place, 0).extinction);
        EXPECT_NEAR(here, block.at(place + Vec3(1, -2, 0), 0).extinction, 1e-5);
        difference += std::abs(here - other.at(place, 0).extinction);
    }
    EXPECT_GT(difference, 0);
}

TEST(FibreBlock, OfStraightHairsPointsAlongThem) {
    TexelSpec spec;
    spec.fibres = FurSpec{.variation = 0, .lean = 30, .droop = 0, .toward = 90, .disorder = 0};
    const TexelBlock block = fibre_block(spec);
    const Fibres fibres = block.at(Vec3(0.5, 0.5, 0.3), block.coarsest());
    ASSERT_GT(fibres.extinction, 0);
    const Vec3 way = fibres.direction / fibres.extinction;
    EXPECT_NEAR((way - Vec3(0, 0.5, std::sqrt(0.75))).length(), 0, 1e-5);
}

/// Axis, x or y, of the thread on top in the middle of a crossing.
int top_thread(const TexelBlock& block, int threads, int warp, int weft) {
    for (double z = 0.99; z > 0; z -= 0.01) {
        const Fibres fibres = block.at(Vec3((weft + 0.5) / threads, (warp + 0.5) / threads, z), 0);
        if (fibres.extinction > 1)
            return std::abs(fibres.direction.x) > std::abs(fibres.direction.y) ? 0 : 1;
    }
    return -1;
}

TEST(FibreBlock, OfClothHasTheThreadsOfItsWeaveOnTop) {
    for (const auto& [weave, threads, of_warp] :
         {std::tuple(Weave::plain, 2, 2), {Weave::twill, 4, 8}, {Weave::satin, 5, 20}}) {
        TexelSpec spec;
        spec.thickness = 1, spec.voxels = 128;
        spec.fibres = ClothSpec{.weave = weave};
        const TexelBlock block = fibre_block(spec);
        int warps = 0;
        for (int i = 0; i < threads; ++i) {
            int in_row = 0;
            for (int j = 0; j < threads; ++j) {
                const int top = top_thread(block, threads, i, j);
                ASSERT_GE(top, 0);
                in_row += top == 0;
            }
            EXPECT_EQ(in_row * threads, of_warp) << i;
            warps += in_row;
        }
        EXPECT_EQ(warps, of_warp);
        if (weave != Weave::twill) continue;
        for (int i = 0; i < threads; ++i) // its ridges go aslant
            for (int j = 0; j < threads; ++j)
                EXPECT_EQ(top_thread(block, threads, i, j),
                          top_thread(block, threads, (i + 1) % 4, (j + 3) % 4));
    }
}

} // namespace
} // namespace keiko
