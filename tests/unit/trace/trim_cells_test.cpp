#include "keiko/trace/trim_cells.h"

#include "keiko/trace/traced_model.h"
#include "keiko/trace/tracer.h"

#include "tests/unit/trace/random_patches.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

using namespace test;

/// A sheet with an outline that no border of the patch follows, and a round hole.
SurfaceModel sheet_with_hole() {
    const LoopData outline = polygon({Vec2(-8, -7.5), Vec2(8, -8.5), Vec2(4, 9), Vec2(-8.5, 6)});
    return ShapeBuilder()
        .face({rectangle(-10, 10, -10, 10, 0)}, {outline, circle(Vec2(-1, 1), 4)})
        .model();
}

TEST(TrimCells, AreMetByTheBoxesThatTouchThem) {
    EXPECT_EQ(TrimCells::met({Vec2(-1), Vec2(1)}), ~TrimCells::Set{0});
    EXPECT_EQ(TrimCells::met({Vec2(-0.99), Vec2(-0.98)}), 1U);
    EXPECT_EQ(TrimCells::met({Vec2(0.99), Vec2(1)}), TrimCells::Set{1} << 63);
    EXPECT_EQ(TrimCells::met({Vec2(-0.8, -0.9), Vec2(-0.7, -0.6)}), 0x0303U);
    EXPECT_EQ(TrimCells::met({Vec2(-9), Vec2(-5)}), 1U) << "beyond the square: at its border";
}

TEST(TrimCells, AgreeWithTheLoopsEverywhere) {
    const TracedModel model =
        traced_model(sheet_with_hole(), TracerOptions().join, TracerOptions().leaf_contraction, {});
    Random random(7);
    std::size_t told = 0, asked = 0;
    for (std::size_t i = 0; i < model.hot.size(); ++i) {
        const Leaf& leaf = model.leaves.leaves[model.placed[i].leaf];
        if (leaf.trim != TrimSide::mixed) continue;
        const TrimCells& cells = model.hot[i].cells;
        EXPECT_EQ(cells.material & cells.empty, 0U);
        for (int k = 0; k < 20000; ++k) {
            const Vec2 uv(uniform(random, 0, 1), uniform(random, 0, 1)), at = uv * 2 - Vec2(1);
            const TrimCells::Set cell = TrimCells::met({at, at});
            const PatchFrame& patch = model.patches[leaf.patch];
            const Vec2 in_face = patch.to_face(leaf.patch_parameters(uv));
            const bool inside = model.faces[patch.face].region.contains(in_face);
            const bool material = (cell & cells.material) != 0, empty = (cell & cells.empty) != 0;
            ASSERT_FALSE(inside ? empty : material) << in_face;
            told += material || empty;
            ++asked;
        }
    }
    ASSERT_GT(asked, 0U);
    EXPECT_GT(told, asked / 3) << "a curve crosses far fewer cells than it leaves alone";
}

} // namespace
} // namespace keiko
