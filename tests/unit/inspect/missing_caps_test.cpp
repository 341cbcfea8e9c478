// Bodies with one hole that are closed elsewhere.
#include "keiko/inspect/openings/missing_caps.h"

#include "keiko/base/units.h"
#include "keiko/inspect/inspection.h"

#include "tests/support/model_builder.h"
#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace keiko {
namespace {

constexpr double join = 0.5;

/// A block with a corner at the origin without some of its faces: z, x and y low and high.
test::ModelBuilder block(const Vec3& size, const std::vector<int>& without) {
    test::ModelBuilder builder;
    const Vec3 x(size.x, 0, 0), y(0, size.y, 0), z(0, 0, size.z);
    int number = 0;
    for (const auto& [u, v, w] : {std::array{x, y, z}, std::array{y, z, x}, std::array{z, x, y}})
        for (const Vec3& from : {Vec3(0), w})
            if (std::find(without.begin(), without.end(), number++) == without.end())
                builder.plane(from, u, v);
    return builder;
}

/// A tube about z, 5 mm in radius and 30 mm high, of four faces.
test::ModelBuilder tube(double bulge = 0) {
    test::ModelBuilder builder;
    const double w = std::sqrt(0.5), r = 5;
    for (int i = 0; i < 4; ++i) {
        const double a = std::acos(-1.0) / 2 * i, c = std::cos(a), s = std::sin(a);
        std::vector<Vec4> points;
        for (const double z : {0.0, 30.0}) {
            const double wave = z > 0 && i % 2 == 0 ? bulge : 0;
            points.emplace_back(r * c, r * s, z, 1);
            points.push_back(Vec4(r * (c - s), r * (s + c), z + wave, 1) * w);
            points.emplace_back(-r * s, r * c, z, 1);
        }
        builder.rational_patch(1, 2, points);
    }
    return builder;
}

/// A flat disc about the z axis, 5 mm in radius.
void disc(test::ModelBuilder& builder, double z) {
    const double w = std::sqrt(0.5), r = 5;
    std::vector<std::vector<Vec3>> circle;
    for (int i = 0; i < 4; ++i) {
        const double a = std::acos(-1.0) / 2 * i, c = std::cos(a), s = std::sin(a);
        const auto at = [&](double x, double y) { return Vec2((x + 1) / 2, (y + 1) / 2); };
        const Vec2 p = at(c, s), q = at(c - s, s + c), t = at(-s, c);
        circle.push_back({{p.x, p.y, 1}, {q.x * w, q.y * w, w}, {t.x, t.y, 1}});
    }
    builder.plane({-r, -r, z}, {2 * r, 0, 0}, {0, 2 * r, 0});
    builder.loop(circle);
}

std::vector<Check> openings_of(const test::ModelBuilder& builder) {
    std::vector<Check> found;
    for (const Check& look : inspect(builder.build(), {}, join).looks)
        if (look.code == "KEIKO-OPENING") found.push_back(look);
    return found;
}

TEST(MissingCaps, OfBlocksAreOpenings) {
    for (const double scale : {0.1, 1.0, 20.0}) {
        const Vec3 size = Vec3(60, 40, 20) * scale;
        for (int face = 0; face < 6; ++face) {
            const auto found = openings_of(block(size, {face}));
            ASSERT_EQ(found.size(), 1u) << scale << ", face " << face;
            const double least = face < 2 ? 40 : 20;
            EXPECT_NEAR(found.front().worst.value, least * scale, 1e-6);
            Vec3 middle = size / 2;
            (face < 2   ? middle.z
             : face < 4 ? middle.x
                        : middle.y) = face % 2 == 0 ? 0
                                      : face < 2    ? size.z
                                      : face < 4    ? size.x
                                                    : size.y;
            EXPECT_LT((found.front().worst.place - middle).length(), 1e-6 * scale);
        }
    }
}

TEST(MissingCaps, OfTubesAreOpenings) {
    test::ModelBuilder closed = tube();
    disc(closed, 0);
    const auto found = openings_of(closed);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found.front().worst.value, 10, 0.01);
    EXPECT_LT((found.front().worst.place - Vec3(0, 0, 30)).length(), 0.01);
    disc(closed, 30);
    EXPECT_TRUE(openings_of(closed).empty());
}

TEST(MissingCaps, MayBeCurved) {
    test::ModelBuilder bulged = tube(0.8);
    disc(bulged, 0);
    EXPECT_EQ(openings_of(bulged).size(), 1u);
}

TEST(MissingCaps, AreNoneOfClosedBodiesNorOfOpenTubes) {
    EXPECT_TRUE(openings_of(block({60, 40, 20}, {})).empty());
    EXPECT_TRUE(openings_of(block({60, 40, 20}, {0, 1})).empty());
    EXPECT_TRUE(openings_of(tube()).empty());
}

TEST(MissingCaps, AreNoneOfPanelsWithFlanges) {
    EXPECT_TRUE(openings_of(block({600, 400, 10}, {0})).empty());
    EXPECT_TRUE(openings_of(block({600, 400, 60}, {0})).empty());
    // A profile of three sides.
    EXPECT_TRUE(openings_of(block({600, 40, 40}, {0, 2, 3})).empty());
}

TEST(MissingCaps, OfStripsAreNoneHoweverTheyLieInTheirPlanes) {
    // A strip 1 mm wide along the diagonal of a plane of 70 mm, of 2 % of its area.
    test::ModelBuilder builder;
    builder.plane({0, 0, 0}, {70, 0, 0}, {0, 70, 0});
    const std::array<Vec2, 4> corners{{{0.02, 0.01}, {0.99, 0.98}, {0.98, 0.99}, {0.01, 0.02}}};
    std::vector<std::vector<Vec3>> outline;
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec2 a = corners[i], b = corners[(i + 1) % 4];
        outline.push_back({{a.x, a.y, 1}, {b.x, b.y, 1}});
    }
    builder.loop(outline);
    EXPECT_TRUE(openings_of(builder).empty());
}

} // namespace
} // namespace keiko
