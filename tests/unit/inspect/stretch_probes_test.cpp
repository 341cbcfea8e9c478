#include "keiko/inspect/seams/stretch_probes.h"

#include "keiko/inspect/inspection.h"

#include "tests/unit/inspect/sheets.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace keiko {
namespace {

/// Two sheets that meet along the x axis; the border of the first is cut at these x, mm.
SurfaceModel cut_sheets(const std::vector<double>& cuts) {
    test::ModelBuilder builder;
    test::flat_sheet(builder, {0, 50, 0});
    std::vector<Vec2> corners{{0, 0}};
    for (const double x : cuts) corners.emplace_back(x / test::sheet_length, 0);
    corners.insert(corners.end(), {{1, 0}, {1, 1}, {0, 1}});
    builder.polygon(corners);
    test::flat_sheet(builder, {0, -50, 0});
    return builder.build();
}

double begin_of(const PlacedProbe& placed) {
    const SeamProbe& probe = placed.probe;
    return probe.place(placed.backwards ? probe.end() : probe.begin()).x;
}

double end_of(const PlacedProbe& placed) {
    const SeamProbe& probe = placed.probe;
    return probe.place(placed.backwards ? probe.begin() : probe.end()).x;
}

void expect_runs_along(const std::vector<PlacedProbe>& probes) {
    double at = begin_of(probes.front());
    EXPECT_TRUE(std::abs(at) < 1e-9 || std::abs(at - test::sheet_length) < 1e-9);
    for (const PlacedProbe& placed : probes) {
        EXPECT_NEAR(begin_of(placed), at, 1e-9);
        at = end_of(placed);
    }
    EXPECT_NEAR(std::abs(at - begin_of(probes.front())), test::sheet_length, 1e-9);
}

TEST(StretchProbes, ArePiecesOneAfterTheOther) {
    const SurfaceModel model = cut_sheets({20, 25, 70});
    const ModelBorders borders(model);
    const Inspection found = inspect(model);
    ASSERT_EQ(found.seams.size(), 1u);
    const StretchProbes probes(borders, found.seams, 0, found.pieces);
    EXPECT_EQ(probes.probes().size(), 4u);
    expect_runs_along(probes.probes());
}

/// In any order of the pieces, and where some of them run against the others. One is 0.001 mm long.
TEST(StretchProbes, AreOrderedHoweverTheyAreListed) {
    const SurfaceModel model = cut_sheets({20, 20.001, 70});
    const ModelBorders borders(model);
    std::vector<Seam> pieces = inspect(model).pieces;
    ASSERT_EQ(pieces.size(), 4u);
    std::vector<std::size_t> order{0, 1, 2, 3};
    do
        for (unsigned turned = 0; turned < 16; ++turned) {
            std::vector<SeamProbe> probes;
            for (const std::size_t i : order) {
                Seam piece = pieces[i];
                if (turned >> i & 1) {
                    // The other side as side a, which runs the other way.
                    std::swap(piece.a, piece.b);
                    if (piece.a.begin > piece.a.end)
                        std::swap(piece.a.begin, piece.a.end),
                            std::swap(piece.b.begin, piece.b.end);
                }
                probes.emplace_back(borders.curves, piece);
            }
            expect_runs_along(in_order(std::move(probes)));
        }
    while (std::next_permutation(order.begin(), order.end()));
}

TEST(StretchProbes, OfAClosedLineStartWithItsFirstPiece) {
    test::ModelBuilder builder;
    builder.plane({0, 0, 0}, {10, 0, 0}, {0, 10, 0});
    const SurfaceModel model = builder.build();
    const BoundaryCurves curves(model);
    std::vector<SeamProbe> probes;
    for (std::uint32_t side = 0; side < 4; ++side) {
        const BoundaryInterval on{0, 0, natural_side + side, 0, 1};
        probes.emplace_back(curves, Seam{on, on, std::nullopt});
    }
    const std::vector<PlacedProbe> ordered = in_order(probes);
    ASSERT_EQ(ordered.size(), 4u);
    EXPECT_EQ(ordered[0].probe.place(0), probes[0].place(0));
    EXPECT_FALSE(ordered[0].backwards);
    for (std::size_t i = 1; i < 4; ++i) {
        const PlacedProbe &before = ordered[i - 1], &after = ordered[i];
        EXPECT_FALSE(after.backwards);
        EXPECT_NEAR((before.probe.place(1) - after.probe.place(0)).length(), 0, 1e-12);
    }
}

} // namespace
} // namespace keiko
