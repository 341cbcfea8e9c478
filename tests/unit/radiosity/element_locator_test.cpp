#include "keiko/radiosity/element_locator.h"

#include "tests/support/model_builder.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

/// Halves of the squares below the diagonal of a grid, `side` a side, over the parameters of a
/// plane.
struct LowerTriangle {
    std::vector<Vec2> uv;
    std::vector<SolvedTriangle> triangles;

    explicit LowerTriangle(std::uint32_t side) {
        for (std::uint32_t j = 0; j <= side; ++j)
            for (std::uint32_t i = 0; i <= side; ++i)
                uv.emplace_back(static_cast<double>(i) / side, static_cast<double>(j) / side);
        const auto corner = [&](std::uint32_t i, std::uint32_t j) { return j * (side + 1) + i; };
        for (std::uint32_t j = 0; j < side; ++j)
            for (std::uint32_t i = 0; i + j < side; ++i) {
                triangles.push_back({{corner(i, j), corner(i + 1, j), corner(i, j + 1)}});
                if (i + j + 1 < side)
                    triangles.push_back(
                        {{corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)}});
            }
    }
};

// Half of the face has no triangles: a cell far from them has those of one of the nearest cells,
// not of all ways to them.
TEST(ElementLocator, FindsPlacesBesideATriangularFace) {
    test::ModelBuilder builder;
    builder.plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    const SurfaceModel model = builder.build();
    const LowerTriangle half(64);
    const ElementLocator locator(model, half.uv, half.triangles);
    for (const Vec2& at : {Vec2(0.3, 0.2), Vec2(0.51, 0.47), Vec2(0.01, 0.97)}) {
        const auto found = locator.at(0, 0, at);
        ASSERT_TRUE(found);
        Vec2 place(0);
        const auto& corners = half.triangles[found->triangle].corners;
        for (int c = 0; c < 3; ++c)
            place += half.uv[corners[static_cast<std::size_t>(c)]] * found->shares[c];
        EXPECT_LT((place - at).length(), 1e-12);
    }
    for (const Vec2& at : {Vec2(0.52, 0.52), Vec2(0.9, 0.3), Vec2(1, 1)}) {
        const auto found = locator.at(0, 0, at);
        ASSERT_TRUE(found);
        const Vec2 corner = half.uv[half.triangles[found->triangle].corners[0]];
        EXPECT_GT(corner.x + corner.y, 0.9);
    }
}

} // namespace
} // namespace keiko
