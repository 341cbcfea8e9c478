#include "keiko/visibility/boundaries/boundary_piece.h"

#include "tests/support/model_builder.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace keiko {
namespace {

/// Boundary pieces of two faces: the square [0, 10]^2 at z = 0 and, from its side x = 10 on,
/// another face of the same size. That one rises by `rise`, begins `gap` farther off and is `width`
/// wide along y.
std::vector<BoundaryPiece> pieces_of_two(double rise, double gap, double width,
                                         int neighbours = 1) {
    test::ModelBuilder builder;
    builder.plane({0, 0, 0}, {10, 0, 0}, {0, 10, 0});
    for (int i = 0; i < neighbours; ++i)
        builder.plane({10 + gap, 0, 0}, {10, 0, rise * (i + 1)}, {0, width, 0});
    builder.instance(Affine());
    const SurfaceModel model = builder.build();
    return boundary_pieces(model, Tracer(model), Job());
}

/// How many pieces of border the surface is known to go on beyond.
std::ptrdiff_t covered(const std::vector<BoundaryPiece>& pieces) {
    return std::count_if(pieces.begin(), pieces.end(), [](const BoundaryPiece& piece) {
        return piece.normal_angle < std::numbers::pi / 2;
    });
}

TEST(AdjacentFaces, GoOnWhereBordersWithoutAnEdgeAreOneCurve) {
    const std::vector<BoundaryPiece> pieces = pieces_of_two(0, 0, 10);
    EXPECT_EQ(covered(pieces), 2);
    for (const BoundaryPiece& piece : pieces)
        if (piece.normal_angle < 1) {
            EXPECT_NEAR(piece.center.x, 10, 1e-12);
            EXPECT_LT(piece.normal_angle, 1e-5);
            EXPECT_NEAR(std::abs(piece.normal.z), 1, 1e-12);
        }
}

TEST(AdjacentFaces, HaveAConeOfBothSidesNormals) {
    for (const BoundaryPiece& piece : pieces_of_two(10, 0, 10)) {
        if (piece.normal_angle > 1) continue;
        EXPECT_NEAR(piece.normal_angle, std::numbers::pi / 8, 1e-5);
        EXPECT_NEAR(std::abs(piece.normal.dot(Vec3(-1, 0, 1 + std::numbers::sqrt2).normalized())),
                    1, 1e-12);
    }
    EXPECT_EQ(covered(pieces_of_two(10, 0, 10)), 2);
}

TEST(AdjacentFaces, OfAPartOfABorderAreThatPartsAlone) {
    EXPECT_EQ(covered(pieces_of_two(0, 0, 9)), 1);
}

TEST(AdjacentFaces, AreNotFoundAcrossGapsOrBetweenThree) {
    EXPECT_EQ(covered(pieces_of_two(0, 1e-6, 10)), 0);
    EXPECT_EQ(covered(pieces_of_two(3, 0, 10, 2)), 0);
}

} // namespace
} // namespace keiko
