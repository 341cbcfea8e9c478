#include "keiko/drawing/curves/body_edges.h"

#include "tests/support/model_builder.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace keiko {
namespace {

/// Two plates side by side. The second one is longer by `more` mm: its corner meets no other.
SurfaceModel plates(double more) {
    test::ModelBuilder builder;
    builder.plane({0, 0, 0}, {100, 0, 0}, {0, 100, 0});
    builder.plane({100, 0, 0}, {100, 0, 0}, {0, 100 + more, 0});
    return builder.build();
}

/// Lengths of the free edges in mm.
std::vector<double> free_edges(const SurfaceModel& model) {
    std::vector<double> lengths;
    const BodyEdges edges(model, {.join = 0.5});
    for (const ModelCurve& curve : edges.curves())
        if (curve.kind == CurveKind::edge) lengths.push_back(curve.course.length());
    return lengths;
}

TEST(BodyEdges, WhatASeamLeavesWithinItsReachIsNoFreeEdge) {
    EXPECT_EQ(free_edges(plates(0)).size(), 6u);
    EXPECT_EQ(free_edges(plates(0.2)).size(), 6u);
}

TEST(BodyEdges, WhatIsLongerThanTheReachIsAFreeEdge) {
    const std::vector<double> lengths = free_edges(plates(3));
    ASSERT_EQ(lengths.size(), 7u);
    EXPECT_NEAR(*std::min_element(lengths.begin(), lengths.end()), 3, 0.51);
}

TEST(BodyEdges, AShortBorderOfItsOwnIsAFreeEdge) {
    test::ModelBuilder builder;
    builder.plane({0, 0, 0}, {0.2, 0, 0}, {0, 100, 0});
    EXPECT_EQ(free_edges(builder.build()).size(), 4u);
}

} // namespace
} // namespace keiko
