#include "keiko/intersect/subpatch/packed_sub_patch.h"
#include "keiko/intersect/subpatch/traced_model.h"
#include "keiko/intersect/traversal/tracer.h"

#include "tests/support/random_patches.h"
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

/// The only sub-patch that curves cross.
struct MixedSubPatch {
    TracedModel model = traced_model(sheet_with_hole(), TracerOptions().join,
                                     TracerOptions().sub_patch_contraction, {});
    const SubPatch& sub_patch = model.sub_patches.sub_patches.front();
    const TrimCells& cells = model.hot.front().cells;

    const TrimRegion& region() const { return model.faces.front().region; }
    Vec2 on_face(const Vec2& uv) const {
        return model.patches.front().to_face(sub_patch.patch_parameters(uv));
    }
};

TEST(TrimCells, AgreeWithTheLoopsEverywhere) {
    const MixedSubPatch mixed;
    ASSERT_EQ(mixed.model.hot.size(), 1U);
    ASSERT_EQ(mixed.sub_patch.trim, TrimSide::mixed);
    Random random(7);
    for (int k = 0; k < 20000; ++k) {
        const Vec2 uv(uniform(random, 0, 1), uniform(random, 0, 1)), at = uv * 2 - Vec2(1);
        const TrimCells::Set cell = TrimCells::at(at);
        ASSERT_EQ(cell, TrimCells::met({at, at}));
        const bool inside = mixed.region().contains(mixed.on_face(uv));
        ASSERT_EQ((inside ? mixed.cells.empty : mixed.cells.material) & cell, 0U) << uv;
    }
}

TEST(TrimCells, TellEveryCellThatNoCurveCrosses) {
    const MixedSubPatch mixed;
    int told = 0;
    for (unsigned cell = 0; cell < 64; ++cell) {
        const Vec2 corner = Vec2(cell % 8, cell / 8) / 8, margin(1e-6);
        Box2 box;
        box.extend(mixed.on_face(corner - margin));
        box.extend(mixed.on_face(corner + Vec2(1.0 / 8) + margin));
        const TrimSide side = mixed.region().classify(box);
        if (side == TrimSide::mixed) continue;
        const TrimCells::Set& set =
            side == TrimSide::inside ? mixed.cells.material : mixed.cells.empty;
        EXPECT_EQ(set >> cell & 1, 1U) << cell;
        ++told;
    }
    EXPECT_GT(told, 10);
}

} // namespace
} // namespace keiko
